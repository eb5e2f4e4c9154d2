// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/chain_library.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/recordings/identification_text.h"
#include "core/base/csv.h"
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/result/determined_parameters.h"
#include "core/identification/result/identification_json.h"
#include "core/identification/validation/validation.h"
#include "core/session/squeeze/hold_history.h"
#include "core/signal/recording/units.h"

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QStringList estimatorNames()
{
    QStringList names;
    for (const Estimator estimator : allEstimators())
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

const QStringList& csvColumns()
{
    static const QStringList columns{
        u"file"_qs,     u"estimator"_qs, u"status"_qs, u"recommended"_qs, u"m"_qs,
        u"m_95"_qs,     u"m_unit"_qs,    u"b"_qs,      u"b_95"_qs,        u"b_unit"_qs,
        u"k"_qs,        u"k_95"_qs,      u"k_unit"_qs, u"intervals"_qs,   u"simulation_percent"_qs,
        u"validity"_qs, u"error"_qs};
    return columns;
}

QString csvRow(QStringList cells)
{
    for (QString& cell : cells)
        cell = csvCell(cell);
    return cells.join(u',');
}

/// m, b and k with half their intervals, and what these count.
struct CsvNumbers {
    std::optional<double> values[3], halves[3];
    QString intervals;
};

CsvNumbers csvNumbers(const Identification& identification, const Estimate& estimate)
{
    CsvNumbers numbers;
    const UncertaintyBudget& budget = identification.budget;
    const bool whole =
        isRecommended(identification, estimate) && (budget.parameters || !budget.further.empty());
    const QString asMeasured = u"1"_qs;
    for (const DeterminedParameter& one : whole ? determinedParameters(identification, asMeasured, asMeasured)
                                                : determinedParameters(estimate, asMeasured, asMeasured)) {
        const std::optional<std::size_t> at = linearPlaceOf(one.parameter);
        if (!at || one.isLowerBound)
            continue;
        numbers.values[*at] = one.value;
        if (!one.interval)
            continue;
        numbers.halves[*at] = (one.interval->upper - one.interval->lower) / 2;
        numbers.intervals = whole ? u"budget"_qs : u"noise"_qs;
    }
    return numbers;
}

/// What `identify --csv` prints: a header, then a row a file and estimator (RFC 4180, decimal points, all
/// digits). m_95, b_95, k_95 are half the 95 % interval: `intervals` says whether of the uncertainty budget
/// (the recommended estimate, whose m, b and k are then without the empty gripper's) or of noise alone.
/// Numbers that do not exist are empty cells.
QString identificationCsvHeader()
{
    return csvColumns().join(u',');
}

QString identificationCsv(const Identification& identification, const Recording& recording,
                          const QString& file)
{
    const ParameterUnits units = parameterUnits(recording.forceUnit, recording.positionUnit);
    const QString unit[] = {units.m, units.b, units.k};
    QStringList rows;
    for (const Estimate& estimate : identification.estimates) {
        const CsvNumbers numbers = csvNumbers(identification, estimate);
        QStringList cells{file, toString(estimate.estimator), toString(estimate.status),
                          isRecommended(identification, estimate) ? u"yes"_qs : u"no"_qs};
        for (std::size_t i = 0; i < 3; ++i)
            cells << exactText(numbers.values[i]) << exactText(numbers.halves[i]) << unit[i];
        cells << numbers.intervals << exactText(estimate.fit.simulationPercent)
              << toString(identification.validity.verdict) << QString();
        rows << csvRow(cells);
    }
    return rows.join(u'\n');
}

/// The row of a file that could not be read.
QString identificationCsv(const QString& file, const Error& error)
{
    QStringList cells(csvColumns().size(), QString());
    cells.front() = file;
    cells.back() = error.describe();
    return csvRow(cells);
}

/// The squeeze that every estimate is held against, where one was named.
struct OtherSqueeze {
    QString file;
    Recording recording;
};

/// What the files have in common: what is known of their grippers, what those before say of the hold, and the
/// squeeze to validate on.
struct Files {
    ChainLibrary chains;
    HoldHistory holds;
    std::optional<OtherSqueeze> other;
};

enum class Output { Text, Json, Csv };

Exit identifyFile(const QString& file, const CsvReadOptions& reading, IdentificationOptions options,
                  Files& files, Output output)
{
    Expected<Recording> recording = readRecordingCsv(file, reading);
    if (!recording) {
        message(u"gripscope-cli: "_qs + recording.error().describe());
        if (output == Output::Json)
            printJson(errorDocument(file, recording.error()));
        else if (output == Output::Csv)
            print(identificationCsv(file, recording.error()));
        return exitFor(recording.error());
    }
    files.chains.complete(*recording, file);
    options.earlierHold = files.holds.before(*recording, options);
    Identification identification = identify(*recording, options);
    files.holds.add(*recording, identification);
    if (const Estimate* best = identification.best(); best != nullptr && files.other)
        identification.validation =
            validateOnRecording(*best, *recording, files.other->recording, files.other->file, options.hold);
    if (output == Output::Json)
        printJson(toJson(identification, *recording, file));
    else if (output == Output::Csv)
        print(identificationCsv(identification, *recording, file));
    else
        print(identificationText(identification, *recording, file));
    return identification.validity.verdict == ValidityVerdict::Invalid ? Exit::NotAType : Exit::Done;
}

} // namespace

int runIdentify(const QStringList& arguments)
{
    CommandLine line(
        u"identify"_qs,
        u"Finds m, b and k, with their errors, in recordings of force and position. Several files of one "
        u"gripper tell together how it holds its force."_qs,
        u"FILE..."_qs, CommandLine::Json::OneAFile);
    line.option(u"estimator"_qs, u"LIST"_qs,
                u"Estimators, separated by commas: %1; all means every one of these."_qs.arg(
                    estimatorNames().join(u", "_qs)),
                u"arx,oe"_qs);
    line.option(u"validate"_qs, u"OTHER.csv"_qs,
                u"Another squeeze, to hold the estimate against: only its start and offset are fitted anew. "
                u"Without it the first 60 % of each record are held against the rest."_qs);
    line.flag(u"csv"_qs, u"As a table: a row a file and estimator, with half the 95 % intervals."_qs);
    addReadingOptions(line);
    addLibraryOption(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const CsvReadOptions reading = csvReadOptions(line);
    IdentificationOptions options = identificationOptions(line);
    const bool json = line.isSet(u"json"_qs), csv = line.isSet(u"csv"_qs);
    if (json && csv)
        line.reject(u"--csv and --json exclude each other."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const Expected<std::vector<Estimator>> chosen = estimators(line.list(u"estimator"_qs));
    if (!chosen)
        return fail(chosen.error());
    options.estimators = *chosen;
    const Expected<QString> library = namedLibraryFile(line);
    if (!library)
        return fail(library.error(), json);
    Files files{ChainLibrary(*library), {}, {}};
    if (const QString file = line.text(u"validate"_qs); !file.isEmpty()) {
        Expected<Recording> recording = readRecordingCsv(file, reading);
        if (!recording)
            return fail(recording.error(), json);
        files.chains.complete(*recording, file);
        files.other = OtherSqueeze{file, std::move(*recording)};
    }

    ExitCode exit;
    if (csv)
        print(identificationCsvHeader());
    for (const QString& file : line.files())
        exit.add(identifyFile(file, reading, options, files,
                              json  ? Output::Json
                              : csv ? Output::Csv
                                    : Output::Text));
    return exit.value();
}

} // namespace gripscope::cli
