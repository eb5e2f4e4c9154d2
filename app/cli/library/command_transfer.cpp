// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/measured_transfer.h"
#include "app/cli/library/shift_json.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/base/json_value.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QJsonValue trialJson(const std::optional<TransferTrial>& trial)
{
    if (!trial)
        return {};
    return QJsonObject{{u"squeezes"_qs, trial->squeezes},
                       {u"named_before"_qs, trial->namedBefore},
                       {u"named_after"_qs, trial->namedAfter},
                       {u"log_density_gain"_qs, jsonNumber(trial->logDensityGain)}};
}

QJsonObject reportJson(const TransferReport& report)
{
    QJsonArray types;
    for (const TypeShift& type : report.types)
        types.append(shiftJson(type));
    QJsonValue factor;
    if (report.error)
        factor = vectorJson((-report.error->value).array().exp());
    return {{u"types"_qs, types},
            {u"error"_qs, report.error ? QJsonValue(commonShiftJson(*report.error)) : QJsonValue()},
            {u"left_out_squeezes"_qs, trialJson(report.error ? std::optional(report.trial) : std::nullopt)},
            {u"left_out_types"_qs, trialJson(report.unseenTypes)},
            {u"adjust"_qs, report.adjust},
            {u"factor"_qs, factor},
            {u"words"_qs, QJsonArray::fromStringList(described(report.words))}};
}

} // namespace

int runTransfer(const QStringList& arguments)
{
    CommandLine line(
        u"transfer"_qs,
        u"How well types that were enrolled on one gripper serve on another: the difference "
        "between the two by a few squeezes of the same types, and whether an adjustment helps."_qs,
        u"OTHER"_qs);
    addLibraryOption(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    if (line.files().size() != 1)
        line.reject(u"Name one library with squeezes of the other gripper, its types by the same names."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    const Expected<QString> home = libraryFile(line);
    if (!home)
        return fail(home.error(), json);
    const Expected<TransferReport> report = measuredTransfer(*home, line.files().front());
    if (!report)
        return fail(report.error(), json);
    if (json) {
        printJson(reportJson(*report));
        return 0;
    }
    print(described(report->words).join(u'\n'));
    if (report->error && report->adjust) {
        const Eigen::Vector3d factor = (-report->error->value).array().exp();
        print(u"Multiply what this gripper finds by %1 (m), %2 (b) and %3 (k)."_qs.arg(
            fixed(factor(0), 4), fixed(factor(1), 4), fixed(factor(2), 4)));
    }
    return 0;
}

} // namespace gripscope::cli
