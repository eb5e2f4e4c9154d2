// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "app/cli/line/output.h"
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

/// The study as `document` or, without --json, as `text`; or why there is none. Returns the exit code.
template <typename Study, typename Document, typename Text>
int showStudy(const Expected<Study>& study, const CommandLine& line, const Document& document,
              const Text& text)
{
    const bool json = line.isSet(QStringLiteral("json"));
    if (!study)
        return fail(study.error(), json);
    if (json)
        printJson(document(*study));
    else
        print(text(*study));
    return 0;
}

/// The options that name the table that studyTable() reads.
void addTableOptions(CommandLine& line);
/// TABLE.csv, or what --library and --batch name (study_table_input.cpp says which columns that has). Usage
/// where neither or both are; so the command's arguments are "[TABLE.csv]", with brackets.
[[nodiscard]] Expected<StudyTable> studyTable(const CommandLine& line);

} // namespace gripscope::cli
