// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "core/base/error.h"

namespace gripscope::cli {

/// --force, of the commands that write recordings.
void addForceOption(CommandLine& line);

/// Whether a recording may be written there. A file that is there already is replaced where it is a recording
/// of this program (a script that runs again) or empty, another one only with --force: FileUnwritable. What
/// is no file, such as /dev/stdout, is written to.
[[nodiscard]] Expected<void> mayReplace(const QString& file, bool force);

} // namespace gripscope::cli
