// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/classification.h"
#include "app/cli/commands.h"
#include "app/cli/exit_code.h"
#include "app/cli/measured_transfer.h"
#include "app/cli/output.h"
#include "app/cli/shared_options.h"
#include "app/cli/verdict_output.h"

#include <QJsonArray>

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
    line.option(u"false-reject"_qs, u"RATE"_qs, u"Share of known parts that may be called unknown."_qs,
                u"0.01"_qs);
    line.option(u"wrong-type"_qs, u"RATE"_qs, u"Share of known parts that may be named another type."_qs,
                u"0.001"_qs);
    line.option(u"stranger-accept"_qs, u"RATE"_qs,
                u"Share of strangers, spread evenly over the instrument's range in logarithms, that may be "
                "named a type."_qs,
                u"0.01"_qs);
    line.option(
        u"confidence"_qs, u"SHARE"_qs,
        u"The false-reject rate holds for this library with this confidence, 0.95 say; without it, on "
        "average over libraries."_qs);
    line.option(u"transfer"_qs, u"OTHER"_qs,
                u"Library with squeezes of the gripper that these recordings are from, where the types were "
                "enrolled on another: see transfer."_qs);
    line.flag(u"robust"_qs, u"For types that spread unlike and heavier tails than a Gaussian's."_qs);
    addReadingOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const CsvReadOptions reading = csvReadOptions(line);
    const IdentificationOptions options = identificationOptions(line);
    VerdictOptions rates;
    rates.falseReject = line.number(u"false-reject"_qs);
    rates.wrongType = line.number(u"wrong-type"_qs);
    rates.strangerAccept = line.number(u"stranger-accept"_qs);
    if (line.isSet(u"confidence"_qs))
        rates.confidence = line.number(u"confidence"_qs);
    rates.robust = line.isSet(u"robust"_qs);
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
    Classification classification(*library, options, rates, *transfer);
    if (const std::optional<Error> error = classification.begin())
        return fail(*error, json);
    ExitCode exit;
    QJsonArray results;
    for (const QString& file : line.files()) {
        const Expected<Verdict> verdict = classification.judge(file, reading);
        if (!verdict) {
            message(u"gripscope-cli: %1"_qs.arg(verdict.error().describe()));
            results.append(errorDocument(file, verdict.error()));
            exit.add(exitFor(verdict.error()));
            continue;
        }
        if (verdict->kind != VerdictKind::Type)
            exit.add(Exit::NotAType);
        results.append(verdictJson(file, *verdict));
        if (!json)
            print(verdictText(file, *verdict));
    }
    if (json)
        printJson({{u"results"_qs, results}});
    return exit.value();
}

} // namespace gripscope::cli
