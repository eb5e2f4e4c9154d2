// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "core/identification/identification.h"
#include "core/recognition/verdict/verdict.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording_csv.h"

namespace gripscope::cli {

/// The options that identify, enroll and classify share: how to read a CSV, and what to assume of it.
void addReadingOptions(CommandLine& line);
[[nodiscard]] CsvReadOptions csvReadOptions(CommandLine& line);
/// Hold, initial state and offset; the estimators stay as they are by default.
[[nodiscard]] IdentificationOptions identificationOptions(CommandLine& line);

/// `--false-reject` and the others that verdicts and advice are held to.
void addRateOptions(CommandLine& line);
[[nodiscard]] bool ratesAreGiven(const CommandLine& line);
/// Not validated.
[[nodiscard]] VerdictOptions verdictRates(CommandLine& line);

/// `--excitation KIND`, `--force-file FILE` and `--periods N`, shared by record and simulate.
void addExcitationKind(CommandLine& line);
[[nodiscard]] ExcitationKind excitationKind(CommandLine& line);
[[nodiscard]] std::size_t excitationPeriods(CommandLine& line); ///< 0: not given

/// `--library DB`, the user's own file without it.
void addLibraryOption(CommandLine& line);
[[nodiscard]] Expected<QString> libraryFile(const CommandLine& line);
/// The same where nothing is to be made: StorageOpen for a file that was named and is not there.
[[nodiscard]] Expected<QString> namedLibraryFile(const CommandLine& line);

} // namespace gripscope::cli
