// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/exit_code.h"
#include "app/cli/identification_text.h"
#include "app/cli/output.h"
#include "app/cli/shared_options.h"
#include "core/identification/identification_json.h"

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QStringList estimatorNames()
{
    QStringList names;
    for (const Estimator estimator : allEstimators)
        names << toString(estimator);
    return names;
}

Expected<std::vector<Estimator>> estimators(const QStringList& list)
{
    std::vector<Estimator> found;
    const QStringList names = list.contains(u"all"_qs) ? estimatorNames() : list;
    for (const QString& name : names) {
        const std::optional<Estimator> estimator = estimatorFromString(name);
        if (!estimator)
            return failure(ErrorCode::Usage, {u"There is no estimator \"%1\"; choose from %2, or all."_qs.arg(
                                                 name, estimatorNames().join(u", "_qs))});
        if (std::find(found.begin(), found.end(), *estimator) == found.end())
            found.push_back(*estimator);
    }
    if (found.empty())
        return failure(ErrorCode::Usage, {u"--estimator names none; choose from %1, or all."_qs.arg(
                                             estimatorNames().join(u", "_qs))});
    return found;
}

Exit identifyFile(const QString& file, const CsvReadOptions& reading, const IdentificationOptions& options,
                  bool json)
{
    const Expected<Recording> recording = readRecordingCsv(file, reading);
    if (!recording) {
        message(u"gripscope-cli: "_qs + recording.error().describe());
        if (json)
            printJson(errorDocument(file, recording.error()));
        return exitFor(recording.error());
    }
    const Identification identification = identify(*recording, options);
    if (json)
        printJson(toJson(identification, *recording, file));
    else
        print(identificationText(identification, *recording, file));
    return identification.validity.verdict == ValidityVerdict::Invalid ? Exit::NotAType : Exit::Done;
}

} // namespace

int runIdentify(const QStringList& arguments)
{
    CommandLine line(u"identify"_qs,
                     u"Finds m, b and k, with their errors, in recordings of force and position."_qs,
                     u"FILE..."_qs);
    line.option(u"estimator"_qs, u"LIST"_qs,
                u"Estimators, separated by commas: %1; all means every one of these."_qs.arg(
                    estimatorNames().join(u", "_qs)),
                u"arx,oe"_qs);
    addReadingOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const CsvReadOptions reading = csvReadOptions(line);
    IdentificationOptions options = identificationOptions(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const Expected<std::vector<Estimator>> chosen = estimators(line.list(u"estimator"_qs));
    if (!chosen)
        return fail(chosen.error());
    options.estimators = *chosen;

    ExitCode exit;
    for (const QString& file : line.files())
        exit.add(identifyFile(file, reading, options, line.isSet(u"json"_qs)));
    return exit.value();
}

} // namespace gripscope::cli
