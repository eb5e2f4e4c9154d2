// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/existing_library.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/quality/library_table.h"
#include "app/cli/quality/quality_commands.h"
#include "core/base/words.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

Expected<StudyTable> tableOfLibrary(const CommandLine& line)
{
    if (line.isSet(u"batch"_qs) && line.text(u"batch"_qs).trimmed().isEmpty())
        return failure(ErrorCode::Usage, {Words::say("--batch needs the name of a batch")});
    ASSIGN_OR_RETURN(const std::unique_ptr<Library> library, libraryFile(line).and_then(openExistingLibrary));
    ASSIGN_OR_RETURN(const LibraryTable found, libraryTable(*library, line.text(u"batch"_qs).trimmed()));
    for (const QString& note : found.notes)
        message(note);
    return found.table;
}

} // namespace

void addTableOptions(CommandLine& line)
{
    line.option(u"library"_qs, u"DB"_qs,
                u"In place of TABLE.csv the squeezes of a library, with the columns %1."_qs.arg(
                    libraryTableColumns().join(u", "_qs)));
    line.option(u"batch"_qs, u"NAME"_qs,
                u"Only the batch of that name (without --library: of the user's own library)."_qs);
}

Expected<StudyTable> studyTable(const CommandLine& line)
{
    const QStringList files = line.files();
    const bool isOfLibrary = line.isSet(u"library"_qs) || line.isSet(u"batch"_qs);
    if (isOfLibrary && !files.isEmpty())
        return failure(
            ErrorCode::Usage,
            {Words::say("a table comes from TABLE.csv or from --library and --batch, not from both")});
    if (isOfLibrary)
        return tableOfLibrary(line);
    if (files.size() != 1)
        return failure(ErrorCode::Usage,
                       {Words::say("one table was expected: TABLE.csv, or --library DB --batch NAME")});
    return StudyTable::read(files.front());
}

} // namespace gripscope::cli
