// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/gripper/profile_commands.h"
#include "app/cli/line/bounded_number.h"
#include "app/cli/line/command_line.h"
#include "app/cli/line/drive.h"
#include "app/cli/line/output.h"
#include "devices/profile/field_values.h"
#include "devices/profile/profiled_device.h"
#include "devices/profile/report_watch.h"

#include <QJsonArray>

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Longer than a device takes to open.
constexpr double watchPatience_s = 15;

using Kind = std::pair<ReportKind, ReportStatistics>;

QString hex(std::uint8_t byte)
{
    return u"%1"_s.arg(byte, 2, 16, QLatin1Char('0')).toUpper();
}

/// What the bytes belong to; empty without a profile or for reports that are not the profile's.
QString ownersIn(const std::optional<GripperProfile>& profile, const ReportKind& kind, std::size_t byte)
{
    const bool meant = profile && kind.length == profile->reportLength && kind.id == profile->reportId;
    return meant ? ownersOfByte(*profile, byte) : QString();
}

QJsonObject documentOf(const Kind& kind, const std::optional<GripperProfile>& profile)
{
    const ReportStatistics& seen = kind.second;
    QJsonArray bytes;
    for (std::size_t i = 0; i < seen.bytes().size(); ++i) {
        const ByteStatistics& byte = seen.bytes()[i];
        bytes.append(QJsonObject{{u"byte"_s, static_cast<int>(i)},
                                 {u"last"_s, byte.last},
                                 {u"least"_s, byte.least},
                                 {u"most"_s, byte.most},
                                 {u"changes"_s, static_cast<qint64>(byte.changes)},
                                 {u"changes_per_second"_s, seen.changesPerSecond(i)},
                                 {u"field"_s, ownersIn(profile, kind.first, i)}});
    }
    QJsonObject document{{u"length"_s, static_cast<int>(kind.first.length)},
                         {u"reports"_s, static_cast<qint64>(seen.reports())},
                         {u"reports_per_second"_s, seen.reportsPerSecond()},
                         {u"bytes"_s, bytes}};
    if (kind.first.id)
        document[u"id"_s] = *kind.first.id;
    return document;
}

QString tableOf(const Kind& kind, const std::optional<GripperProfile>& profile)
{
    const ReportStatistics& seen = kind.second;
    QString text = u"%1 reports of %2 bytes%3, %4 a second.\n"_s.arg(seen.reports())
                       .arg(kind.first.length)
                       .arg(kind.first.id ? u" with ID %1"_s.arg(*kind.first.id) : QString())
                       .arg(seen.reportsPerSecond(), 0, 'f', 1);
    text += u"%1%2%3%4%5  %6"_s.arg(u"byte"_s, 4)
                .arg(u"last"_s, 6)
                .arg(u"least"_s, 7)
                .arg(u"most"_s, 6)
                .arg(u"changes/s"_s, 11)
                .arg(profile ? u"field"_s : QString())
                .trimmed();
    for (std::size_t i = 0; i < seen.bytes().size(); ++i) {
        const ByteStatistics& byte = seen.bytes()[i];
        const QString changes = byte.moves() ? QString::number(seen.changesPerSecond(i), 'f', 1) : u"-"_s;
        QString row = u"\n%1%2%3%4%5  %6"_s.arg(i, 4)
                          .arg(hex(byte.last), 6)
                          .arg(hex(byte.least), 7)
                          .arg(hex(byte.most), 6)
                          .arg(changes, 11)
                          .arg(ownersIn(profile, kind.first, i));
        while (row.endsWith(u' '))
            row.chop(1);
        text += row;
    }
    return text;
}

/// The last report that the profile is about, field by field.
std::vector<FieldValue> lastValues(const std::vector<Kind>& kinds, const GripperProfile& profile)
{
    for (const Kind& kind : kinds)
        if (const std::vector<FieldValue> values = fieldValues(profile, kind.second.last()); !values.empty())
            return values;
    return {};
}

QString inWords(const FieldValue& value)
{
    QString text = u"%1%2  %3"_s.arg(value.name, -10)
                       .arg(QString::number(value.number, 'g', 10), 14)
                       .arg(QString::number(value.value, 'g', 10));
    if (!value.unit.isEmpty())
        text += u' ' + value.unit;
    return value.words.isEmpty() ? text : text + u"  ("_s + value.words + u')';
}

QJsonObject documentOf(const FieldValue& value)
{
    QJsonObject document{{u"name"_s, value.name},
                         {u"sample"_s, static_cast<int>(value.index)},
                         {u"number"_s, value.number},
                         {u"value"_s, value.value},
                         {u"unit"_s, value.unit}};
    if (value.name == u"status")
        document[u"flags"_s] = value.words;
    return document;
}

void tell(const ReportWatch::Snapshot& seen, const std::vector<Kind>& kinds,
          const std::optional<GripperProfile>& profile)
{
    for (const Kind& kind : kinds)
        print(tableOf(kind, profile));
    if (!profile)
        return;
    QString text = u"\n%1%2  %3"_s.arg(u"field"_s, -10).arg(u"number"_s, 14).arg(u"value"_s);
    for (const FieldValue& value : lastValues(kinds, *profile))
        text += u'\n' + inWords(value);
    print(text);
    const QString lost = profile->lossEvidence() == LossEvidence::None ? u"what was lost cannot be seen"_s
                                                                       : u"%1 lost"_s.arg(seen.lostSamples);
    print(u"\n%1 samples, %2, %3 reports came twice, %4 were not as the profile says, %5 had another ID.%6"_s
              .arg(seen.samples)
              .arg(lost)
              .arg(seen.duplicateReports)
              .arg(seen.badReports)
              .arg(seen.otherReports)
              .arg(seen.restarted ? u" The counter or the clock went back."_s : QString()));
}

QJsonObject documentOf(const ReportWatch::Snapshot& seen, const std::vector<Kind>& kinds,
                       const std::optional<GripperProfile>& profile)
{
    QJsonArray reports;
    for (const Kind& kind : kinds)
        reports.append(documentOf(kind, profile));
    QJsonObject document{{u"kinds"_s, reports}};
    if (!profile)
        return document;
    QJsonArray fields;
    for (const FieldValue& value : lastValues(kinds, *profile))
        fields.append(documentOf(value));
    const bool visible = profile->lossEvidence() != LossEvidence::None;
    document[u"profile"_s] = profile->name;
    document[u"fields"_s] = fields;
    document[u"samples"_s] = static_cast<qint64>(seen.samples);
    document[u"lost_samples"_s] = visible ? QJsonValue(static_cast<qint64>(seen.lostSamples)) : QJsonValue();
    document[u"duplicate_reports"_s] = static_cast<qint64>(seen.duplicateReports);
    document[u"bad_reports"_s] = static_cast<qint64>(seen.badReports);
    document[u"other_reports"_s] = static_cast<qint64>(seen.otherReports);
    return document;
}

/// The profile asked for, or the one that a connection would use, or none.
Expected<std::optional<GripperProfile>> wantedProfile(const QString& device, const QString& file)
{
    if (!file.isEmpty())
        return namedProfile(file).map([](const GripperProfile& profile) { return std::optional(profile); });
    const Expected<GripperProfile> known = profileAt(device);
    return known ? std::optional(*known) : std::nullopt;
}

/// Listens for so long; the error when nothing came at all.
Expected<ReportWatch::Snapshot> listen(std::shared_ptr<Transport> transport,
                                       const std::optional<GripperProfile>& profile, double seconds)
{
    ReportWatch watch;
    watch.use(profile);
    watch.start(std::move(transport));
    ReportWatch::Snapshot seen;
    const auto look = [&] { seen = watch.snapshot(); };
    const auto ended = [&] { return seen.state == ReportWatch::State::Ended; };
    static_cast<void>(drive(
        look, [&] { return ended() || seen.state == ReportWatch::State::Listening; }, watchPatience_s));
    if (!ended())
        static_cast<void>(drive(look, ended, seconds));
    watch.stop(std::chrono::milliseconds(500)); // before the program ends
    if (seen.kinds.empty())
        return tl::unexpected<Error>(seen.error.value_or(
            Error{ErrorCode::DeviceTimeout, {u"send anything"_s, QString::number(seconds)}}));
    return seen;
}

} // namespace

int watchReports(const QStringList& arguments)
{
    CommandLine line(
        u"profile watch"_s,
        u"Listens to a gripper and tells which bytes of its reports move, and what they say by a "
        "profile. Nothing is sent to it."_s);
    line.option(u"device"_s, u"ADDRESS"_s, u"hid:VENDOR:PRODUCT:SERIAL, or virtual: with options."_s);
    line.option(u"profile"_s, u"FILE"_s, u"Reads the reports by it; without, by the one that is known."_s);
    line.option(u"seconds"_s, u"SECONDS"_s, u"How long to listen."_s, u"2"_s);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const QString device = line.text(u"device"_s);
    const double seconds = boundedNumber(line, u"seconds"_s, 1e-3, 86'400);
    if (device.isEmpty())
        line.reject(u"--device ADDRESS is missing; gripscope-cli devices lists them."_s);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);

    const Expected<std::optional<GripperProfile>> profile = wantedProfile(device, line.text(u"profile"_s));
    if (!profile)
        return fail(profile.error(), json);
    const Expected<std::shared_ptr<Transport>> transport = listenAt(device);
    if (!transport)
        return fail(transport.error(), json);
    catchInterrupts();
    const Expected<ReportWatch::Snapshot> seen = listen(*transport, *profile, seconds);
    if (!seen)
        return fail(seen.error(), json);
    std::vector<Kind> kinds(seen->kinds.begin(), seen->kinds.end());
    std::stable_sort(kinds.begin(), kinds.end(),
                     [](const Kind& a, const Kind& b) { return a.second.reports() > b.second.reports(); });
    if (json)
        printJson(documentOf(*seen, kinds, *profile));
    else
        tell(*seen, kinds, *profile);
    return 0;
}

} // namespace gripscope::cli
