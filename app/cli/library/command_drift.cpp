// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/existing_library.h"
#include "app/cli/library/shift_json.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/base/json_value.h"
#include "core/quality/drift.h"
#include "core/session/inspect/inspected_squeezes.h"

#include <QJsonArray>

#include <utility>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QJsonObject typeJson(const TypeDrift& type)
{
    return {{u"type"_qs, type.type},
            {u"squeezes"_qs, type.squeezes},
            {u"averages"_qs, vectorJson(type.average)},
            {u"t_squared"_qs, jsonNumber(type.tSquared)},
            {u"first_alarm"_qs, type.firstAlarm ? QJsonValue(*type.firstAlarm) : QJsonValue()},
            {u"shift"_qs, type.shift ? QJsonValue(shiftJson(*type.shift)) : QJsonValue()},
            {u"moved"_qs, type.moved}};
}

QJsonObject reportJson(const DriftReport& report, const InspectedSqueezes& inspected,
                       const DriftOptions& options)
{
    QJsonArray types;
    for (const TypeDrift& type : report.types)
        types.append(typeJson(type));
    return {{u"cause"_qs, toString(report.cause)},
            {u"moved"_qs, QJsonArray::fromStringList(report.moved)},
            {u"types"_qs, types},
            {u"factor"_qs, report.factor ? QJsonValue(commonShiftJson(*report.factor)) : QJsonValue()},
            {u"addition"_qs, report.addition ? QJsonValue(commonShiftJson(*report.addition)) : QJsonValue()},
            {u"limits"_qs, QJsonObject{{u"average"_qs, report.averageLimit},
                                       {u"t_squared"_qs, report.tSquaredLimit},
                                       {u"run_length"_qs, options.averageRunLength},
                                       {u"false_alarm"_qs, options.falseAlarm}}},
            {u"squeezes"_qs, qint64(inspected.squeezes.size())},
            {u"left_out"_qs, inspected.leftOut},
            {u"words"_qs, QJsonArray::fromStringList(described(report.words))}};
}

QString reportText(const DriftReport& report, const InspectedSqueezes& inspected)
{
    QStringList lines = described(report.words);
    lines << u"%1 inspected squeezes of known types; %2 left out (of no known type, or invalid)."_qs
                 .arg(inspected.squeezes.size())
                 .arg(inspected.leftOut);
    for (const TypeDrift& type : report.types)
        lines << u"%1: %2 squeezes; averages m %3, b %4, k %5 (limit %6), T^2 %7 (limit %8)"_qs.arg(
            type.type, QString::number(type.squeezes), fixed(type.average(0), 2), fixed(type.average(1), 2),
            fixed(type.average(2), 2), fixed(report.averageLimit, 2), fixed(type.tSquared, 1),
            fixed(report.tSquaredLimit, 1));
    return lines.join(u'\n');
}

void addDriftOptions(CommandLine& line)
{
    const DriftOptions options;
    line.option(u"recent"_qs, u"N"_qs, u"The last squeezes of a type that are held against its enrolment."_qs,
                QString::number(options.recent));
    line.option(
        u"run-length"_qs, u"N"_qs,
        u"Squeezes of a type from one false alarm of its charts to the next, on average, at least."_qs,
        QString::number(options.averageRunLength));
    line.option(u"weight"_qs, u"W"_qs, u"Weight of the newest squeeze in the moving averages."_qs,
                QString::number(options.weight));
    line.option(u"false-alarm"_qs, u"RATE"_qs,
                u"Share of looks in which something is said to have moved that has not."_qs,
                QString::number(options.falseAlarm));
}

DriftOptions driftOptions(CommandLine& line)
{
    DriftOptions options;
    options.recent = line.integer(u"recent"_qs, 1, 1'000'000);
    options.averageRunLength = line.number(u"run-length"_qs);
    options.weight = line.number(u"weight"_qs);
    options.falseAlarm = line.number(u"false-alarm"_qs);
    return options;
}

/// What was looked at and what was found.
struct Findings {
    InspectedSqueezes inspected;
    DriftReport report;
};

Expected<Findings> examine(const QString& file, const DriftOptions& options)
{
    ASSIGN_OR_RETURN(const std::unique_ptr<Library> library, openExistingLibrary(file));
    ASSIGN_OR_RETURN(const TypeModels models, approvedModels(*library));
    ASSIGN_OR_RETURN(InspectedSqueezes inspected, inspectedSqueezes(*library));
    ASSIGN_OR_RETURN(DriftReport report, findDrift(models, inspected.squeezes, options));
    return Findings{std::move(inspected), std::move(report)};
}

} // namespace

int runDrift(const QStringList& arguments)
{
    CommandLine line(u"drift"_qs,
                     u"Holds the inspected squeezes of each type against its enrolment: has anything moved, "
                     "and is it the sensor, the fingers or the product?"_qs);
    addLibraryOption(line);
    addDriftOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const DriftOptions options = driftOptions(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    if (const std::optional<Error> error = options.validate())
        return fail(*error, json);
    const Expected<QString> file = libraryFile(line);
    if (!file)
        return fail(file.error(), json);
    const Expected<Findings> found = examine(*file, options);
    if (!found)
        return fail(found.error(), json);
    if (json)
        printJson(reportJson(found->report, found->inspected, options));
    else
        print(reportText(found->report, found->inspected));
    return 0;
}

} // namespace gripscope::cli
