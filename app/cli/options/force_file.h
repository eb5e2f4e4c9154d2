// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "core/signal/excitation/force_levels.h"

#include <optional>

namespace gripscope::cli {

/// `--force-file FILE`, shared by record and simulate. The kind of excitation is then "levels", and asking
/// for another one makes no sense; nor does that kind without a file.
void addForceFile(CommandLine& line);
void checkForceFile(CommandLine& line);

/// Puts the force of the file into `excitation`: where --bias and --peak say and with levels as long as
/// --bit, as far as these are given, else as the file has it. The force is returned; nothing without the
/// option.
[[nodiscard]] Expected<std::optional<ForceLevels>> takeForceFile(const CommandLine& line,
                                                                 ExcitationOptions& excitation);

} // namespace gripscope::cli
