// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "core/library/library.h"

#include <functional>

namespace gripscope::cli {

/// The type of that name, in use or retired. NotFound.
[[nodiscard]] Expected<TypeRecord> requireNamed(const Library& library, const QString& name);
/// Parses what every action has (--library, --json) and what this one needs; the exit code when nothing is
/// left to do. finish() is still to be asked.
[[nodiscard]] std::optional<int> parseWith(CommandLine& line, const QStringList& arguments,
                                           const QStringList& needed = {});
/// Opens the library and works with it; the exit code, after telling what went wrong.
[[nodiscard]] int withLibrary(const CommandLine& line, const std::function<Expected<void>(Library&)>& work);
/// --reason and --operator.
void addNoteOptions(CommandLine& line);
[[nodiscard]] ChangeNote note(const CommandLine& line);
void addTypeOption(CommandLine& line); ///< --type NAME

/// Tells the newest change: {"version": .., "kind": .., "change": ..}.
[[nodiscard]] Expected<void> tellChange(const Library& library, bool json);

} // namespace gripscope::cli
