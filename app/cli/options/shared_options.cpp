// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/options/shared_options.h"

#include "app/cli/line/bounded_number.h"
#include "app/cli/options/force_file.h"
#include "core/library/library.h"
#include "core/signal/recording/foreign_table.h"
#include "core/signal/recording/recording_limits.h"

#include <QFileInfo>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

void addReadingOptions(CommandLine& line)
{
    line.option(u"force-column"_qs, u"NAME"_qs, u"Column with the force (without it: force)."_qs);
    line.option(u"position-column"_qs, u"NAME"_qs, u"Column with the position (without it: position)."_qs);
    line.option(u"sample-time"_qs, u"SECONDS"_qs,
                u"Time from sample to sample, where the file does not say."_qs);
    line.option(u"time-column"_qs, u"NAME"_qs, u"Column with the times (without it: time_s, if there)."_qs);
    line.option(u"time-unit"_qs, u"UNIT"_qs, u"Unit of the times: s, ms, us, ns."_qs, u"s"_qs);
    line.option(u"delimiter"_qs, u"NAME"_qs,
                u"comma, semicolon or tab (without it: what the header has its columns by)."_qs);
    line.flag(u"decimal-comma"_qs,
              u"Numbers have decimal commas (without it: as the first that has a mark)."_qs);
    line.option(u"skip-lines"_qs, u"N"_qs, u"Lines of the file to pass over before the header."_qs, u"0"_qs);
    line.option(u"skip-below"_qs, u"N"_qs, u"Lines to pass over below the header, such as units."_qs,
                u"0"_qs);
    line.flag(u"no-header"_qs, u"There is no line of names: the columns are 1, 2, 3 ..."_qs);
    line.option(u"force-unit"_qs, u"UNIT"_qs,
                u"Unit of the force: uN, mN, N, kN, gf, kgf, lbf (without it: the file's, else 1)."_qs);
    line.option(u"position-unit"_qs, u"UNIT"_qs,
                u"Unit of the position: nm, um, mm, cm, m, in (without it: the file's, else 1)."_qs);
    line.option(
        u"hold"_qs, u"HOLD"_qs,
        u"The force between samples: zoh (held) or foh (a straight line). Without it: the file's, else foh."_qs);
    line.option(u"initial-state"_qs, u"STATE"_qs, u"free, or rest: the part is still at the first sample."_qs,
                u"free"_qs);
    line.option(u"offset"_qs, u"OFFSET"_qs, u"free, or fixed: position is zero where there is no force."_qs,
                u"free"_qs);
}

namespace {

constexpr int mostSkipped = 1'000'000;

CsvFormat csvFormat(CommandLine& line)
{
    CsvFormat format;
    if (line.isSet(u"delimiter"_qs))
        format.delimiter = ",;\t"[line.choice(u"delimiter"_qs, {u"comma"_qs, u"semicolon"_qs, u"tab"_qs})];
    if (line.isSet(u"decimal-comma"_qs))
        format.decimalMark = ',';
    format.skippedLines = static_cast<std::size_t>(line.integer(u"skip-lines"_qs, 0, mostSkipped));
    format.linesBelow = static_cast<std::size_t>(line.integer(u"skip-below"_qs, 0, mostSkipped));
    format.header = !line.isSet(u"no-header"_qs);
    return format;
}

} // namespace

CsvReadOptions csvReadOptions(CommandLine& line)
{
    CsvReadOptions options;
    options.forceColumn = line.text(u"force-column"_qs);
    options.positionColumn = line.text(u"position-column"_qs);
    if (line.isSet(u"sample-time"_qs))
        options.sampleTime_s =
            boundedNumber(line, u"sample-time"_qs, shortestSampleTime_s, longestSampleTime_s);
    options.timeColumn = line.text(u"time-column"_qs);
    (void)line.choice(u"time-unit"_qs, {u"s"_qs, u"ms"_qs, u"us"_qs, u"ns"_qs});
    options.timeUnit_s = secondsPer(line.text(u"time-unit"_qs)).value_or(1);
    options.format = csvFormat(line);
    options.forceUnit = line.text(u"force-unit"_qs);
    options.positionUnit = line.text(u"position-unit"_qs);
    return options;
}

IdentificationOptions identificationOptions(CommandLine& line)
{
    IdentificationOptions options;
    if (line.isSet(u"hold"_qs))
        options.hold =
            line.choice(u"hold"_qs, {u"zoh"_qs, u"foh"_qs}) == 0 ? ForceHold::Zero : ForceHold::First;
    options.initialState = line.choice(u"initial-state"_qs, {u"free"_qs, u"rest"_qs}) == 0
                               ? InitialState::Free
                               : InitialState::Rest;
    options.freeOffset = line.choice(u"offset"_qs, {u"free"_qs, u"fixed"_qs}) == 0;
    return options;
}

void addRateOptions(CommandLine& line)
{
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
    line.flag(u"robust"_qs, u"For types that spread unlike and heavier tails than a Gaussian's."_qs);
}

bool ratesAreGiven(const CommandLine& line)
{
    return line.isSet(u"false-reject"_qs) || line.isSet(u"wrong-type"_qs) ||
           line.isSet(u"stranger-accept"_qs) || line.isSet(u"confidence"_qs) || line.isSet(u"robust"_qs);
}

VerdictOptions verdictRates(CommandLine& line)
{
    VerdictOptions rates;
    rates.falseReject = line.number(u"false-reject"_qs);
    rates.wrongType = line.number(u"wrong-type"_qs);
    rates.strangerAccept = line.number(u"stranger-accept"_qs);
    if (line.isSet(u"confidence"_qs))
        rates.confidence = line.number(u"confidence"_qs);
    rates.robust = line.isSet(u"robust"_qs);
    return rates;
}

void addExcitationKind(CommandLine& line)
{
    line.option(
        u"excitation"_qs, u"KIND"_qs,
        u"step, prbs, four-level (prbs that also tells friction), prbs-sine (friction best), prbs-hold "
        "(what goes on yielding), multisine, chirp, inverse-repeat (for the estimator periodic) or levels "
        "(with "
        "--force-file)."_qs,
        u"prbs"_qs);
    addForceFile(line);
    line.option(u"periods"_qs, u"N"_qs,
                u"How often inverse-repeat (without it: 8) or multisine (1) repeats within the record."_qs);
}

ExcitationKind excitationKind(CommandLine& line)
{
    QStringList names;
    for (const ExcitationKind kind : excitationKinds())
        names << toString(kind);
    (void)line.choice(u"excitation"_qs, names);
    checkForceFile(line);
    return excitationKindFromString(line.text(u"excitation"_qs)).value_or(ExcitationKind::Prbs);
}

std::size_t excitationPeriods(CommandLine& line)
{
    return line.isSet(u"periods"_qs) ? static_cast<std::size_t>(line.integer(u"periods"_qs, 1, 1'000'000))
                                     : 0;
}

void addLibraryOption(CommandLine& line)
{
    line.option(u"library"_qs, u"DB"_qs,
                u"File with the types and squeezes, or postgresql://USER@HOST:PORT/DATABASE (without it: the "
                "user's own library)."_qs);
}

Expected<QString> libraryFile(const CommandLine& line)
{
    const QString name = line.text(u"library"_qs);
    if (line.isSet(u"library"_qs) && name.isEmpty())
        return failure(ErrorCode::Usage,
                       {u"--library needs the name of a file, or the address of a database."_qs});
    return name.isEmpty() ? Library::defaultFile() : Library::placeFrom(name);
}

Expected<QString> namedLibraryFile(const CommandLine& line)
{
    Expected<QString> file = libraryFile(line);
    if (!file || !line.isSet(u"library"_qs))
        return file;
    ASSIGN_OR_RETURN(const bool isThere, Library::isThere(*file));
    if (!isThere)
        return failure(ErrorCode::StorageOpen, {*file, u"there is no such file"_qs});
    return file;
}

} // namespace gripscope::cli
