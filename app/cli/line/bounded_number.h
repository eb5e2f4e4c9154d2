// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"

namespace gripscope::cli {

/// The option's number, which has to lie from `least` to `most`; else it is remembered as one that makes no
/// sense, and `least` stands for it.
[[nodiscard]] double boundedNumber(CommandLine& line, const QString& name, double least, double most);

} // namespace gripscope::cli
