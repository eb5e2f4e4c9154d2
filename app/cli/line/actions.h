// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/commands.h"

namespace gripscope::cli {

/// Runs the action of `command` that the first argument names, with what follows it. Without one: help, or a
/// usage error that names them all. `purpose` is a sentence.
[[nodiscard]] int runAction(const QString& command, const QString& purpose,
                            const std::vector<Command>& actions, const QStringList& arguments);

} // namespace gripscope::cli
