// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"

#include <functional>

namespace gripscope::cli {

// The studies of `gripscope-cli study NAME`; `arguments` follow the name. They return the exit code.
int runEfficiencyStudy(const QStringList& arguments);
int runRecognitionStudy(const QStringList& arguments);
int runEarlyStudy(const QStringList& arguments);
int runTruthStudy(const QStringList& arguments);

/// --runs (`runs` if not given), --seed and --threads, which every study has.
void addStudyOptions(CommandLine& line, int runs);
/// Their values, into options that name them alike.
template <typename Options>
void readStudyOptions(CommandLine& line, Options& options)
{
    options.runs = line.integer(QStringLiteral("runs"), 1, 1'000'000);
    options.seed = line.seed();
    options.threads = line.integer(QStringLiteral("threads"), 0, 1024);
}
/// `study efficiency --models`, after the line was parsed.
[[nodiscard]] int runModelStudy(CommandLine& line, const QStringList& models);
/// A line on standard error at each twentieth of the way.
[[nodiscard]] std::function<void(std::int64_t, std::int64_t)> progressLines();

} // namespace gripscope::cli
