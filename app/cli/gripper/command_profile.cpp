// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/gripper/profile_commands.h"
#include "app/cli/library/outside_change.h"
#include "app/cli/line/actions.h"
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "core/people/audit_entry.h"
#include "devices/profile/profile_library.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

const std::vector<Command>& profileActions()
{
    static const std::vector<Command> all{
        {u"check"_s, u"says what is wrong with profiles, place by place"_s, checkProfiles},
        {u"show"_s, u"the fields of a profile as a table"_s, showProfile},
        {u"list"_s, u"the profiles that grippers are found by"_s, listProfiles},
        {u"install"_s, u"checks a profile and puts it where grippers are found by it"_s, installProfiles},
        {u"watch"_s, u"which bytes of a gripper's reports move, and what they say by a profile"_s,
         watchReports},
    };
    return all;
}

QString lossInWords(LossEvidence evidence)
{
    switch (evidence) {
    case LossEvidence::SequenceNumber:
        return u"sequence number"_s;
    case LossEvidence::Clock:
        return u"clock"_s;
    case LossEvidence::None:
        break;
    }
    return u"cannot be seen"_s;
}

QJsonObject summaryOf(const GripperProfile& profile)
{
    return {{u"name"_s, profile.name},
            {u"maker"_s, profile.maker},
            {u"device"_s, profile.usbNumbers()},
            {u"samples_per_second"_s, profile.samplesPerSecond},
            {u"loss_seen_by"_s, lossInWords(profile.lossEvidence())},
            {u"commandable"_s, false}};
}

void tellProblems(const QString& file, const std::vector<ProfileProblem>& problems, bool json)
{
    QJsonArray list;
    for (const ProfileProblem& problem : problems) {
        list.append(QJsonObject{
            {u"pointer"_s, problem.pointer}, {u"found"_s, problem.found}, {u"expected"_s, problem.expected}});
        message(toError(problem, file).describe());
    }
    if (!json)
        return;
    QJsonObject document = errorDocument(file, toError(problems.front(), file));
    document[u"problems"_s] = list;
    printJson(document);
}

void checkFile(const QString& file, bool json, ExitCode& exit)
{
    const Expected<QByteArray> bytes = readProfileBytes(file);
    if (!bytes) {
        exit.add(exitFor(bytes.error()));
        message(bytes.error().describe());
        if (json)
            printJson(errorDocument(file, bytes.error()));
        return;
    }
    const ProfileReading reading = readProfile(*bytes);
    if (!reading.profile) {
        exit.add(Exit::BadInput);
        return tellProblems(file, reading.problems, json);
    }
    if (json) {
        QJsonObject document = summaryOf(*reading.profile);
        document[u"file"_s] = file;
        printJson(document);
    } else {
        print(u"%1: fine. %2, USB %3, %4 samples a second; losses: %5."_s.arg(
            file, reading.profile->name, reading.profile->usbNumbers(),
            QString::number(reading.profile->samplesPerSecond),
            lossInWords(reading.profile->lossEvidence())));
    }
}

QString bytesInWords(const ProfileField& field)
{
    return field.size() == 1 ? QString::number(field.byte)
                             : u"%1 to %2"_s.arg(field.byte).arg(field.end() - 1);
}

/// How the number becomes a value, in words.
QString meaningOf(const GripperProfile& profile, const QString& name)
{
    const auto channel = [](const ProfileChannel& is) {
        return u"x %1 %2 %3 %4"_s.arg(QString::number(is.scale, 'g', 12), is.offset < 0 ? u"-"_s : u"+"_s,
                                      QString::number(std::abs(is.offset), 'g', 12), is.unit);
    };
    if (name == u"force")
        return channel(profile.force);
    if (name == u"position")
        return channel(profile.position);
    if (name == u"sequence")
        return profile.sequence->countsSamples ? u"counts samples"_s : u"counts reports"_s;
    if (name == u"time")
        return u"x %1 %2"_s.arg(QString::number(profile.time->scale, 'g', 12), profile.time->unit);
    QStringList flags;
    for (const ProfileFlag& flag : profile.status->flags)
        flags << u"bit %1%2: %3"_s.arg(flag.bit)
                     .arg(flag.whenSet ? QString() : u" clear"_s)
                     .arg(flagName(flag.meaning));
    return flags.join(u", "_s);
}

QJsonObject fieldDocument(const GripperProfile& profile, const NamedField& named)
{
    return {{u"name"_s, named.name},
            {u"byte"_s, static_cast<int>(named.field->byte)},
            {u"size"_s, static_cast<int>(named.field->size())},
            {u"type"_s, toString(named.field->type)},
            {u"endian"_s, named.field->bigEndian ? u"big"_s : u"little"_s},
            {u"bits"_s, static_cast<int>(named.field->width())},
            {u"meaning"_s, meaningOf(profile, named.name)}};
}

QString tableOf(const GripperProfile& profile)
{
    QString text = u"%1 (%2), USB %3. It is only listened to.\n"_s.arg(
        profile.name, profile.maker.isEmpty() ? u"maker not said"_s : profile.maker, profile.usbNumbers());
    text += u"Report%1: %2 bytes, %3 a second, samples in each: %4. Losses: %5.\n\n"_s
                .arg(profile.reportId ? u" with ID %1"_s.arg(*profile.reportId) : QString())
                .arg(profile.reportLength)
                .arg(1 / profile.reportTime_s())
                .arg(profile.samples)
                .arg(lossInWords(profile.lossEvidence()));
    text += u"%1%2%3%4%5"_s.arg(u"field"_s, -10)
                .arg(u"bytes"_s, -10)
                .arg(u"type"_s, -6)
                .arg(u"endian"_s, -8)
                .arg(u"means"_s);
    for (const NamedField& named : fieldsOf(profile))
        text += u"\n%1%2%3%4%5"_s.arg(named.name, -10)
                    .arg(bytesInWords(*named.field), -10)
                    .arg(toString(named.field->type), -6)
                    .arg(named.field->size() == 1 ? u"-"_s
                         : named.field->bigEndian ? u"big"_s
                                                  : u"little"_s,
                         -8)
                    .arg(meaningOf(profile, named.name));
    return text;
}

} // namespace

int checkProfiles(const QStringList& arguments)
{
    CommandLine line(u"profile check"_s, u"Says what is wrong with profiles, place by place."_s,
                     u"FILE..."_s);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    ExitCode exit;
    for (const QString& file : line.files())
        checkFile(file, line.isSet(u"json"_s), exit);
    return exit.value();
}

int showProfile(const QStringList& arguments)
{
    CommandLine line(u"profile show"_s,
                     u"Shows the fields of a profile: a file, or the name of one that came with the "
                     "program (example_big_endian, example_float_stream, example_bare)."_s,
                     u"FILE"_s);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const Expected<GripperProfile> profile = namedProfile(line.files().first());
    if (!profile)
        return fail(profile.error(), json);
    if (!json) {
        print(tableOf(*profile));
        return 0;
    }
    QJsonArray fields;
    for (const NamedField& named : fieldsOf(*profile))
        fields.append(fieldDocument(*profile, named));
    QJsonObject document = summaryOf(*profile);
    document[u"fields"_s] = fields;
    printJson(document);
    return 0;
}

int listProfiles(const QStringList& arguments)
{
    CommandLine line(u"profile list"_s, u"Lists the profiles that grippers are found by."_s);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const ProfileCollection known = loadProfiles();
    QJsonArray profiles;
    QString text = u"%1%2%3"_s.arg(u"usb"_s, -12).arg(u"name"_s, -32).arg(u"file"_s);
    for (const KnownProfile& one : known.profiles) {
        QJsonObject entry = summaryOf(one.profile);
        entry[u"file"_s] = one.file;
        entry[u"shipped"_s] = one.shipped;
        profiles.append(entry);
        text += u"\n%1%2%3"_s.arg(one.profile.usbNumbers(), -12)
                    .arg(one.profile.name, -32)
                    .arg(one.shipped ? u"came with the program"_s : one.file);
    }
    for (const Error& error : known.errors)
        message(error.describe());
    if (line.isSet(u"json"_s))
        printJson({{u"profiles"_s, profiles}, {u"folder"_s, userProfileFolder()}});
    else
        print(text);
    return known.errors.empty() ? 0 : static_cast<int>(Exit::BadInput);
}

int installProfiles(const QStringList& arguments)
{
    CommandLine line(u"profile install"_s,
                     u"Checks a profile and puts it into your own folder of profiles, by which grippers are "
                     "found. One for the same gripper is replaced."_s,
                     u"FILE"_s);
    addOutsideChangeOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const QString file = line.files().first();
    const Expected<QByteArray> bytes = readProfileBytes(file);
    if (!bytes)
        return fail(bytes.error(), json);
    const Expected<GripperProfile> profile = readProfileFile(file);
    if (!profile)
        return fail(profile.error(), json);
    // It says what a gripper's numbers mean, so that it decides about verdicts.
    const Expected<void> told =
        tellOutsideChange(line, QString::fromUtf16(audit_action::profileInstalled), profile->name,
                          {{u"device"_s, profile->usbNumbers()}, {u"file"_s, file}});
    if (!told)
        return fail(told.error(), json);
    const Expected<QString> installed = installProfile(*bytes);
    if (!installed)
        return fail(installed.error(), json);
    if (json)
        printJson({{u"file"_s, file}, {u"installed"_s, *installed}});
    else
        print(u"Installed as %1."_s.arg(*installed));
    return 0;
}

int runProfile(const QStringList& arguments)
{
    return runAction(u"profile"_s, u"Teaches Gripscope the reports of other makers' grippers."_s,
                     profileActions(), arguments);
}

} // namespace gripscope::cli
