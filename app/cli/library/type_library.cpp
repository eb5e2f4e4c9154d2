// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/type_library.h"

#include "app/cli/library/existing_library.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// The library of --library, or the user's own. An absent one is an error, not made.
Expected<std::unique_ptr<Library>> openExisting(const CommandLine& line)
{
    return libraryFile(line).and_then(openExistingLibrary);
}

} // namespace

Expected<TypeRecord> requireNamed(const Library& library, const QString& name)
{
    ASSIGN_OR_RETURN(const auto type, library.findType(name.trimmed()));
    if (!type)
        return failure(ErrorCode::NotFound, {u"type %1"_qs.arg(name)});
    return *type;
}

std::optional<int> parseWith(CommandLine& line, const QStringList& arguments, const QStringList& needed)
{
    addLibraryOption(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return exit;
    for (const QString& name : needed)
        if (line.text(name).trimmed().isEmpty())
            line.reject(u"--%1 is missing."_qs.arg(name));
    return {};
}

void addNoteOptions(CommandLine& line)
{
    line.option(u"reason"_qs, u"TEXT"_qs, u"Why; kept with the change."_qs);
    line.option(u"operator"_qs, u"NAME"_qs, u"Who; kept with the change."_qs);
}

ChangeNote note(const CommandLine& line)
{
    return {line.text(u"operator"_qs), line.text(u"reason"_qs)};
}

void addTypeOption(CommandLine& line)
{
    line.option(u"type"_qs, u"NAME"_qs, u"Name of the type."_qs);
}

int withLibrary(const CommandLine& line, const std::function<Expected<void>(Library&)>& work)
{
    const bool json = line.isSet(u"json"_qs);
    const auto library = openExisting(line);
    if (!library)
        return fail(library.error(), json);
    if (const Expected<void> done = work(**library); !done)
        return fail(done.error(), json);
    return 0;
}

Expected<void> tellChange(const Library& library, bool json)
{
    ASSIGN_OR_RETURN(const auto changes, library.changes(1));
    const LibraryChange& change = changes.front();
    if (json)
        printJson({{u"version"_qs, change.version},
                   {u"kind"_qs, toString(change.kind)},
                   {u"change"_qs, inWords(change)}});
    else
        print(u"Version %1: %2"_qs.arg(change.version).arg(inWords(change)));
    return {};
}

} // namespace gripscope::cli
