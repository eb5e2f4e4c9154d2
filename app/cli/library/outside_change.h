// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "core/base/error.h"

#include <QJsonObject>

namespace gripscope::cli {

/// --library, --operator and --reason, for what is changed outside of a library and told to it.
void addOutsideChangeOptions(CommandLine& line);

/// Asks for consent where people are in the library that is meant or in the user's own, and tells their audit
/// trails what is about to be done: what cannot be told is not to be done. Nothing where there is no library.
[[nodiscard]] Expected<void> tellOutsideChange(const CommandLine& line, const QString& action,
                                               const QString& subject, const QJsonObject& details);

/// Asks on the terminal, "y" being yes. True where standard input is none: a script has made up its mind.
[[nodiscard]] bool confirmed(const QString& question);

} // namespace gripscope::cli
