// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/quality/quality_commands.h"
#include "core/base/words.h"

namespace gripscope::cli {

void addTableOptions(CommandLine& /*line*/) {}

Expected<StudyTable> studyTable(const CommandLine& line)
{
    const QStringList files = line.files();
    if (files.size() != 1)
        return failure(ErrorCode::Usage, {Words::say("one table was expected: TABLE.csv")});
    return StudyTable::read(files.front());
}

} // namespace gripscope::cli
