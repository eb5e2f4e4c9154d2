// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command_line.h"

#include <functional>

namespace gripscope::cli {

// The studies of `gripscope-cli study NAME`; `arguments` follow the name. They return the exit code.
int runEfficiencyStudy(const QStringList& arguments);
int runRecognitionStudy(const QStringList& arguments);
int runEarlyStudy(const QStringList& arguments);

/// --runs (`runs` if not given), --seed and --threads, which every study has.
void addStudyOptions(CommandLine& line, int runs);
/// A line on standard error at each twentieth of the way.
[[nodiscard]] std::function<void(std::int64_t, std::int64_t)> progressLines();

} // namespace gripscope::cli
