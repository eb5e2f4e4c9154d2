// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/profile_json.h"

#include "core/base/bounded_file.h"
#include "core/base/words.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A hundred times the longest that makes sense.
constexpr qint64 largestProfile = megabyte;

// Reading: the document has passed the schema, so every value has the type it is read as.

ProfileField readField(const QJsonObject& json)
{
    ProfileField field;
    field.byte = static_cast<std::size_t>(json[u"byte"_s].toInt());
    field.type = fieldTypeFromString(json[u"type"_s].toString()).value_or(FieldType::U8);
    field.bigEndian = json[u"endian"_s].toString() == u"big";
    field.firstBit = static_cast<unsigned>(json[u"first_bit"_s].toInt());
    field.bits = static_cast<unsigned>(json[u"bits"_s].toInt());
    field.sharesBytes = json[u"shares_bytes"_s].toBool();
    return field;
}

std::optional<double> readNumber(const QJsonValue& json)
{
    return json.isDouble() ? std::optional(json.toDouble()) : std::nullopt;
}

ProfileChannel readChannel(const QJsonObject& json)
{
    ProfileChannel channel;
    channel.field = readField(json);
    channel.scale = json[u"scale"_s].toDouble(1);
    channel.offset = json[u"offset"_s].toDouble();
    channel.unit = json[u"unit"_s].toString();
    channel.saturatesBelow = readNumber(json[u"saturates_below"_s]);
    channel.saturatesAbove = readNumber(json[u"saturates_above"_s]);
    return channel;
}

ProfileStatus readStatus(const QJsonObject& json)
{
    ProfileStatus status;
    status.field = readField(json);
    const QJsonArray flags = json[u"flags"_s].toArray();
    for (const auto& flag : flags)
        status.flags.push_back({static_cast<unsigned>(flag[u"bit"_s].toInt()),
                                flagFromName(flag[u"means"_s].toString()), flag[u"when"_s].toInt(1) != 0});
    return status;
}

std::uint16_t readUsbNumber(const QJsonValue& json)
{
    return static_cast<std::uint16_t>(json.toString().toUInt(nullptr, 16));
}

void readReport(const QJsonObject& json, GripperProfile& profile)
{
    if (json.contains(u"id"_s))
        profile.reportId = static_cast<std::uint8_t>(json[u"id"_s].toInt());
    profile.reportLength = static_cast<std::size_t>(json[u"length"_s].toInt());
    profile.samplesPerSecond = json[u"samples_per_second"_s].toDouble();
    profile.samples = static_cast<std::size_t>(json[u"samples"_s].toInt(1));
    profile.stride = static_cast<std::size_t>(json[u"stride"_s].toInt());
}

void readFields(const QJsonObject& json, GripperProfile& profile)
{
    profile.force = readChannel(json[u"force"_s].toObject());
    profile.position = readChannel(json[u"position"_s].toObject());
    if (const QJsonObject sequence = json[u"sequence"_s].toObject(); !sequence.isEmpty())
        profile.sequence = {readField(sequence), sequence[u"counts"_s].toString() == u"samples"};
    if (const QJsonObject time = json[u"time"_s].toObject(); !time.isEmpty())
        profile.time = {readField(time), time[u"scale"_s].toDouble(1), time[u"unit"_s].toString()};
    if (const QJsonObject status = json[u"status"_s].toObject(); !status.isEmpty())
        profile.status = readStatus(status);
}

GripperProfile readDocument(const QJsonObject& json)
{
    GripperProfile profile;
    profile.name = json[u"name"_s].toString();
    profile.maker = json[u"maker"_s].toString();
    profile.notes = json[u"notes"_s].toString();
    profile.vendor = readUsbNumber(json[u"device"_s][u"vendor"_s]);
    profile.product = readUsbNumber(json[u"device"_s][u"product"_s]);
    readReport(json[u"report"_s].toObject(), profile);
    profile.hold = forceHoldFromString(json[u"force_hold"_s].toString()).value_or(ForceHold::Zero);
    profile.forceLag_s = json[u"force_lag_s"_s].toDouble();
    readFields(json[u"fields"_s].toObject(), profile);
    return profile;
}

ProfileProblem syntaxProblem(const QByteArray& json, const QJsonParseError& error)
{
    const QByteArray before = json.left(error.offset - 1); // the offset is behind what was found
    const qsizetype line = before.count('\n') + 1;
    const qsizetype column = before.size() - before.lastIndexOf('\n');
    return {u":%1:%2"_s.arg(line).arg(column), error.errorString(), Words::tr("a JSON document")};
}

// Writing: what has its default is left out.

QJsonObject writeField(const ProfileField& field)
{
    QJsonObject json{{u"byte"_s, static_cast<int>(field.byte)}, {u"type"_s, toString(field.type)}};
    if (field.size() > 1)
        json[u"endian"_s] = field.bigEndian ? u"big"_s : u"little"_s;
    if (field.firstBit > 0)
        json[u"first_bit"_s] = static_cast<int>(field.firstBit);
    if (field.bits > 0)
        json[u"bits"_s] = static_cast<int>(field.bits);
    if (field.sharesBytes)
        json[u"shares_bytes"_s] = true;
    return json;
}

QJsonObject writeChannel(const ProfileChannel& channel)
{
    QJsonObject json = writeField(channel.field);
    json[u"scale"_s] = channel.scale;
    if (channel.offset != 0)
        json[u"offset"_s] = channel.offset;
    json[u"unit"_s] = channel.unit;
    if (channel.saturatesBelow)
        json[u"saturates_below"_s] = *channel.saturatesBelow;
    if (channel.saturatesAbove)
        json[u"saturates_above"_s] = *channel.saturatesAbove;
    return json;
}

QJsonObject writeStatus(const ProfileStatus& status)
{
    QJsonObject json = writeField(status.field);
    QJsonArray flags;
    for (const ProfileFlag& flag : status.flags) {
        QJsonObject entry{{u"bit"_s, static_cast<int>(flag.bit)}, {u"means"_s, flagName(flag.meaning)}};
        if (!flag.whenSet)
            entry[u"when"_s] = 0;
        flags.append(entry);
    }
    json[u"flags"_s] = flags;
    return json;
}

QJsonObject writeFields(const GripperProfile& profile)
{
    QJsonObject json{{u"force"_s, writeChannel(profile.force)},
                     {u"position"_s, writeChannel(profile.position)}};
    if (profile.sequence) {
        QJsonObject sequence = writeField(profile.sequence->field);
        sequence[u"counts"_s] = profile.sequence->countsSamples ? u"samples"_s : u"reports"_s;
        json[u"sequence"_s] = sequence;
    }
    if (profile.time) {
        QJsonObject time = writeField(profile.time->field);
        time[u"scale"_s] = profile.time->scale;
        time[u"unit"_s] = profile.time->unit;
        json[u"time"_s] = time;
    }
    if (profile.status)
        json[u"status"_s] = writeStatus(*profile.status);
    return json;
}

QJsonObject writeReport(const GripperProfile& profile)
{
    QJsonObject json{{u"length"_s, static_cast<int>(profile.reportLength)},
                     {u"samples_per_second"_s, profile.samplesPerSecond}};
    if (profile.reportId)
        json[u"id"_s] = *profile.reportId;
    if (profile.samples > 1)
        json[u"samples"_s] = static_cast<int>(profile.samples);
    if (profile.stride > 0)
        json[u"stride"_s] = static_cast<int>(profile.stride);
    return json;
}

} // namespace

ProfileReading readProfile(const QByteArray& json)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError)
        return {std::nullopt, {syntaxProblem(json, error)}};
    if (!document.isObject())
        return {std::nullopt, {{QString(), Words::tr("a list"), Words::tr("an object in braces")}}};
    if (std::vector<ProfileProblem> problems = checkAgainstSchema(document.object()); !problems.empty())
        return {std::nullopt, std::move(problems)};
    GripperProfile profile = readDocument(document.object());
    if (std::vector<ProfileProblem> problems = findProfileProblems(profile); !problems.empty())
        return {std::nullopt, std::move(problems)};
    return {std::move(profile), {}};
}

Error toError(const ProfileProblem& problem, const QString& file)
{
    const bool isJson = !problem.pointer.startsWith(u':');
    return {ErrorCode::BadInput,
            {file + (isJson ? u"#"_s : QString()) + problem.pointer, Words::tr("found %1").arg(problem.found),
             Words::tr("expected %1").arg(problem.expected)}};
}

Expected<QByteArray> readProfileBytes(const QString& file)
{
    return readBounded(file, largestProfile);
}

Expected<GripperProfile> readProfileFile(const QString& file)
{
    ASSIGN_OR_RETURN(const QByteArray json, readProfileBytes(file));
    ProfileReading reading = readProfile(json);
    if (!reading.profile)
        return tl::unexpected<Error>(toError(reading.problems.front(), file));
    return std::move(*reading.profile);
}

QByteArray writeProfile(const GripperProfile& profile)
{
    const auto hex = [](std::uint16_t number) { return u"%1"_s.arg(number, 4, 16, QLatin1Char('0')); };
    QJsonObject json{
        {u"gripscope_profile"_s, 1},
        {u"name"_s, profile.name},
        {u"commandable"_s, false},
        {u"device"_s, QJsonObject{{u"vendor"_s, hex(profile.vendor)}, {u"product"_s, hex(profile.product)}}},
        {u"report"_s, writeReport(profile)},
        {u"force_hold"_s, toString(profile.hold)},
        {u"fields"_s, writeFields(profile)},
    };
    if (!profile.maker.isEmpty())
        json[u"maker"_s] = profile.maker;
    if (!profile.notes.isEmpty())
        json[u"notes"_s] = profile.notes;
    if (profile.forceLag_s != 0)
        json[u"force_lag_s"_s] = profile.forceLag_s;
    return QJsonDocument(json).toJson();
}

} // namespace gripscope
