// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/authorization.h"
#include "app/cli/library/library_commands.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/library/backup/library_backup.h"
#include "core/library/backup/library_restore.h"

#include <QJsonObject>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QJsonObject toJson(const LibraryContents& contents)
{
    return {{u"types"_s, contents.types},
            {u"squeezes"_s, contents.squeezes},
            {u"inspections"_s, contents.inspections},
            {u"newest"_s, contents.newest.toString(Qt::ISODateWithMs)}};
}

/// The one file that is named, or a usage error.
QString namedFile(CommandLine& line)
{
    if (line.files().size() != 1)
        line.reject(u"Name one FILE."_s);
    return line.files().value(0);
}

CopyProgress unwatched()
{
    return [](double) { return true; };
}

struct MadeBackup {
    QString file;
    LibraryBackup backup;
};

Expected<MadeBackup> makeBackup(const CommandLine& line, const QString& copy)
{
    ASSIGN_OR_RETURN(const QString library, namedLibraryFile(line));
    ASSIGN_OR_RETURN(LibraryBackup backup, backUpLibrary(library, copy, unwatched()));
    ASSIGN_OR_RETURN(const auto opened, Library::open(library));
    opened->actAs({line.text(u"operator"_s), {}, {}});
    RETURN_IF_ERROR(opened->tellBackup(copy, backup.verified.rows));
    return MadeBackup{copy, std::move(backup)};
}

/// Who puts it back, by the people of the library; a damaged one cannot be asked.
Expected<Acting> whoRestores(const RestorePlan& plan, const QString& operatorName)
{
    if (!plan.present)
        return Acting{operatorName, {}, {}};
    auto acting = Library::open(plan.library).and_then([&](const std::unique_ptr<Library>& library) {
        return authorization(*library, operatorName, Permission::RestoreLibrary);
    });
    if (!acting && acting.error().code == ErrorCode::StorageCorrupt)
        return Acting{operatorName, {}, {}};
    return acting;
}

Expected<QString> putBack(const CommandLine& line, const RestorePlan& plan)
{
    const Expected<Acting> acting = whoRestores(plan, line.text(u"operator"_s));
    if (acting)
        return restoreLibrary(plan, *acting, line.text(u"reason"_s));
    discard(plan);
    return tl::unexpected(acting.error());
}

} // namespace

int backUp(const QStringList& arguments)
{
    CommandLine line(
        u"library backup"_s,
        u"Copies a library, also while programs use it, into the new FILE, and verifies the copy. "
        "Exit code 6: it was written, but something in it is not as it was written."_s,
        u"FILE"_s);
    line.option(u"operator"_s, u"NAME"_s, u"Who; kept in the library's audit trail."_s);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    const QString copy = namedFile(line);
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto made = makeBackup(line, copy);
    if (!made)
        return fail(made.error(), json);
    const LibraryVerification& verified = made->backup.verified;
    if (json) {
        QJsonObject document = toJson(made->backup.contents);
        document.insert(u"file"_s, copy);
        document.insert(u"whole"_s, verified.whole());
        printJson(document);
    } else {
        print(u"%1: %2 rows"_s.arg(copy).arg(verified.rows));
        if (!verified.whole())
            print(inWords(verified));
    }
    return static_cast<int>(verified.whole() ? Exit::Done : Exit::Differs);
}

int restore(const QStringList& arguments)
{
    CommandLine line(u"library restore"_s,
                     u"Verifies the backup FILE and puts a copy of it in the library's place. The library of "
                     "before is kept beside it under a dated name. No other program may have it open."_s,
                     u"FILE"_s);
    line.option(u"reason"_s, u"TEXT"_s, u"Why; kept in the audit trail of both."_s);
    line.option(u"operator"_s, u"NAME"_s, u"Who; kept in the audit trail of both."_s);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    const QString backup = namedFile(line);
    if (line.text(u"reason"_s).trimmed().isEmpty())
        line.reject(u"Say why: --reason TEXT is kept with the change."_s);
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto plan = libraryFile(line).and_then(
        [&](const QString& library) { return prepareRestore(library, backup, unwatched()); });
    if (!plan)
        return fail(plan.error(), json);
    const auto keptAs = putBack(line, *plan);
    if (!keptAs)
        return fail(keptAs.error(), json);
    if (json) {
        QJsonObject document = toJson(plan->holds);
        document.insert(u"kept_as"_s, *keptAs);
        printJson(document);
    } else {
        print(u"The library of before is kept as %1"_s.arg(*keptAs));
    }
    return static_cast<int>(Exit::Done);
}

} // namespace gripscope::cli
