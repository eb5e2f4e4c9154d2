// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shared_options.h"

#include "app/cli/bounded_number.h"
#include "core/library/library.h"
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
    line.option(u"force-unit"_qs, u"UNIT"_qs,
                u"Unit of the force: uN, mN, N, kN (without it: the file's, else 1)."_qs);
    line.option(u"position-unit"_qs, u"UNIT"_qs,
                u"Unit of the position: nm, um, mm, cm, m (without it: the file's, else 1)."_qs);
    line.option(
        u"hold"_qs, u"HOLD"_qs,
        u"The force between samples: zoh (held) or foh (a straight line). Without it: the file's, else foh."_qs);
    line.option(u"initial-state"_qs, u"STATE"_qs, u"free, or rest: the part is still at the first sample."_qs,
                u"free"_qs);
    line.option(u"offset"_qs, u"OFFSET"_qs, u"free, or fixed: position is zero where there is no force."_qs,
                u"free"_qs);
}

CsvReadOptions csvReadOptions(CommandLine& line)
{
    CsvReadOptions options;
    options.forceColumn = line.text(u"force-column"_qs);
    options.positionColumn = line.text(u"position-column"_qs);
    if (line.isSet(u"sample-time"_qs))
        options.sampleTime_s =
            boundedNumber(line, u"sample-time"_qs, shortestSampleTime_s, longestSampleTime_s);
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

void addExcitationKind(CommandLine& line)
{
    line.option(u"excitation"_qs, u"KIND"_qs,
                u"step, prbs, multisine, chirp or inverse-repeat (for the estimator periodic)."_qs,
                u"prbs"_qs);
    line.option(u"periods"_qs, u"N"_qs,
                u"How often inverse-repeat (without it: 8) or multisine (1) repeats within the record."_qs);
}

ExcitationKind excitationKind(CommandLine& line)
{
    (void)line.choice(u"excitation"_qs,
                      {u"step"_qs, u"prbs"_qs, u"multisine"_qs, u"chirp"_qs, u"inverse-repeat"_qs});
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
                u"File with the types and squeezes (without it: the user's own library)."_qs);
}

Expected<QString> libraryFile(const CommandLine& line)
{
    const QString name = line.text(u"library"_qs);
    if (name.startsWith(u"postgresql:"_qs) || name.startsWith(u"postgres:"_qs))
        return failure(ErrorCode::NotSupportedYet, {u"A library on a PostgreSQL server"_qs});
    if (line.isSet(u"library"_qs) && name.isEmpty())
        return failure(ErrorCode::Usage, {u"--library needs the name of a file."_qs});
    return name.isEmpty() ? Library::defaultFile() : name;
}

Expected<QString> namedLibraryFile(const CommandLine& line)
{
    Expected<QString> file = libraryFile(line);
    if (file && line.isSet(u"library"_qs) && !QFileInfo::exists(*file))
        return failure(ErrorCode::StorageOpen, {*file, u"there is no such file"_qs});
    return file;
}

} // namespace gripscope::cli
