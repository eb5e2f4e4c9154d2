// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "core/quality/table/study_table.h"

namespace gripscope::cli {

// `gripscope-cli study NAME TABLE.csv` of measurement systems, charts and limits; `arguments` follow the
// name. They return the exit code.
int runGaugeStudy(const QStringList& arguments);
int runTypeOneStudy(const QStringList& arguments);
int runLinearityStudy(const QStringList& arguments);
int runAttributeStudy(const QStringList& arguments);
int runCapabilityStudy(const QStringList& arguments);
int runChartStudy(const QStringList& arguments);
int runGuardBandStudy(const QStringList& arguments);

/// The options that name the table that studyTable() reads.
void addTableOptions(CommandLine& line);
/// TABLE.csv, or what --library and --batch name. Usage where neither or both are.
[[nodiscard]] Expected<StudyTable> studyTable(const CommandLine& line);

} // namespace gripscope::cli
