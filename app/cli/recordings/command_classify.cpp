// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/measured_transfer.h"
#include "app/cli/line/bounded_number.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/recordings/classification.h"

#include <QJsonArray>

#include <utility>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// The adjustment for the gripper whose squeezes `other` holds; none without a library of that kind, or where
/// it would not help.
Expected<std::optional<CommonShift>> transferFrom(const QString& other, const QString& library)
{
    if (other.isEmpty())
        return std::optional<CommonShift>();
    ASSIGN_OR_RETURN(const TransferReport report, measuredTransfer(library, other));
    for (const Finding& sentence : report.words)
        message(sentence.describe());
    return report.adjust ? report.error : std::nullopt;
}

} // namespace

int runClassify(const QStringList& arguments)
{
    CommandLine line(u"classify"_qs,
                     u"Says for each recording which enrolled type it shows, or that it is none."_qs,
                     u"FILE..."_qs);
    addLibraryOption(line);
    addRateOptions(line);
    line.flag(u"refuse-overdue"_qs,
              u"Does not judge what was measured with a calibration that was overdue; without it such a "
              "measurement is suspect."_qs);
    line.option(u"most-lost"_qs, u"SHARE"_qs,
                u"Does not judge where a larger share of a squeeze's samples was lost, 0.02 say; 0: no limit "
                "but the one beyond which no measurement is valid."_qs,
                u"0"_qs);
    line.option(u"transfer"_qs, u"OTHER"_qs,
                u"Library with squeezes of the gripper that these recordings are from, where the types were "
                "enrolled on another: see transfer."_qs);
    addReadingOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const CsvReadOptions reading = csvReadOptions(line);
    const IdentificationOptions options = identificationOptions(line);
    const VerdictOptions rates = verdictRates(line);
    JudgingPolicy policy;
    policy.calibrationOverdue = line.isSet(u"refuse-overdue"_qs);
    policy.mostLostShare = boundedNumber(line, u"most-lost"_qs, 0, 1);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    if (const std::optional<Error> error = rates.validate())
        return fail(*error, json);
    const Expected<QString> library = existingLibrary(line);
    if (!library)
        return fail(library.error(), json);

    const Expected<std::optional<CommonShift>> transfer = transferFrom(line.text(u"transfer"_qs), *library);
    if (!transfer)
        return fail(transfer.error(), json);
    Classification classification(*library, options, rates);
    if (line.isSet(u"transfer"_qs))
        classification.setTransfer(*transfer);
    classification.setPolicy(policy);
    if (const std::optional<Error> error = classification.begin())
        return fail(*error, json);
    ExitCode exit;
    QJsonArray results;
    bool isAdjustmentTold = false;
    for (const QString& file : line.files()) {
        const Expected<InspectSession::Result> result = classification.judge(file, reading);
        if (!result) {
            message(u"gripscope-cli: %1"_qs.arg(result.error().describe()));
            results.append(errorDocument(file, result.error()));
            exit.add(exitFor(result.error()));
            continue;
        }
        if (result->verdict.kind != VerdictKind::Type)
            exit.add(Exit::NotAType);
        QJsonObject document = verdictJson(file, result->verdict);
        if (result->refused)
            document[u"refused"_qs] = true;
        if (!result->adjustmentId.isEmpty())
            document[u"adjustment"_qs] = result->adjustmentId;
        results.append(document);
        if (!json)
            print(verdictText(file, result->verdict));
        if (!result->adjustmentId.isEmpty() && !std::exchange(isAdjustmentTold, true))
            message(u"Adjusted to the gripper that the types were enrolled on, as the library has it; "
                    "--transfer states another adjustment."_qs);
    }
    if (json)
        printJson({{u"results"_qs, results}});
    return exit.value();
}

} // namespace gripscope::cli
