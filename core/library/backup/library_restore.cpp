// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/backup/library_restore.h"

#include "core/base/words.h"
#include "core/library/backup/library_swap.h"
#include "core/library/backup/server_copies.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/migrations/migration.h"
#include "core/library/migrations/schema_check.h"
#include "core/library/sql/file_identity.h"
#include "core/library/sql/synced_names.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/permission_check.h"
#include "core/library/tables/write_transaction.h"
#include "core/library/verification/library_verification.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const QStringList& parts()
{
    static const QStringList suffixes{u""_s, u"-wal"_s, u"-shm"_s, u"-journal"_s};
    return suffixes;
}

void removeAll(const QString& file)
{
    QFile::remove(witnessFile(file));
    for (const QString& part : parts())
        QFile::remove(file + part);
}

/// Of what was found in the copy: a person knows the backup only.
Error aboutBackup(Error error, const RestorePlan& plan)
{
    if (error.argument(0) == plan.staged)
        error.arguments[0] = plan.backup;
    return error;
}

/// `ends` are in the library of `database`.
Expected<bool> holds(Database& database, const std::map<QString, ChainEnd>& ends)
{
    for (const auto& [chain, end] : ends) {
        ASSIGN_OR_RETURN(const QByteArray hash, ledger_table::hashOf(database, chain, end.links));
        if (hash != end.hash)
            return false;
    }
    return true;
}

Expected<Kinship> kinshipOf(Database& backup, Database& present)
{
    ASSIGN_OR_RETURN(const auto birth, ledger_table::birth(backup));
    ASSIGN_OR_RETURN(const auto presentBirth, ledger_table::birth(present));
    if (birth != presentBirth)
        return Kinship::Other;
    ASSIGN_OR_RETURN(const auto ends, ledger_table::ends(backup));
    ASSIGN_OR_RETURN(const auto presentEnds, ledger_table::ends(present));
    if (ends == presentEnds)
        return Kinship::Same;
    ASSIGN_OR_RETURN(const bool earlier, holds(present, ends));
    return earlier ? Kinship::Earlier : Kinship::Apart;
}

Expected<void> bringUpToDate(const QString& from, const QString& copy)
{
    RETURN_IF_ERROR(copyDatabase(from, copy, [](double) { return true; }));
    const PassingLibrary passing(copy); // the second place does not know it by this name
    {
        ASSIGN_OR_RETURN(const auto older, Database::open(copy));
        RETURN_IF_ERROR(migrate(*older));
    }
    return foldIntoOneFile(copy);
}

/// One of an earlier version in a copy that is brought up to date, so that it can be compared. One that
/// cannot be, since it is not as this program made it, stays as it is.
Expected<std::unique_ptr<Database>> inThisVersion(std::unique_ptr<Database> found, const QString& copy)
{
    ASSIGN_OR_RETURN(const int version, schemaVersion(*found));
    const int newest = migrations().back().version;
    if (version > newest) // whatever it holds, it is not for this program to put aside
        return failure(ErrorCode::StorageNewer,
                       {found->file(), QString::number(version), QString::number(newest)});
    if (version == 0 || version == newest)
        return found;
    if (const auto done = bringUpToDate(found->file(), copy);
        !done && done.error().code == ErrorCode::StorageOpen)
        return found;
    else if (!done)
        return tl::unexpected(done.error());
    return Database::openToRead(copy);
}

/// What the library is now; nothing of a damaged one, which is what a backup is for.
Expected<void> compareWith(Database& present, RestorePlan& plan, Database& staged)
{
    ASSIGN_OR_RETURN(const auto differences, schemaDifferences(present));
    if (!differences.empty())
        return {};
    ASSIGN_OR_RETURN(const LibraryContents contents, contentsOf(present));
    ASSIGN_OR_RETURN(plan.kinship, kinshipOf(staged, present));
    plan.present = contents;
    return {};
}

/// What may pass, such as a disk without room, and what a newer program wrote are no damage.
bool isDamage(const Error& error, const QString& library)
{
    switch (error.code) {
    case ErrorCode::StorageCorrupt:
        return true;
    case ErrorCode::StorageOpen:
        return !QFileInfo::exists(library) || Database::isOfAnotherKind(library);
    default:
        return false;
    }
}

Expected<void> lookAtPresent(RestorePlan& plan, Database& staged)
{
    const QString copy = plan.staged + u"-present"_s;
    removeAll(copy); // of one that was killed
    auto looked =
        Database::openToRead(plan.library)
            .and_then([&](std::unique_ptr<Database> found) { return inThisVersion(std::move(found), copy); })
            .and_then([&](const std::unique_ptr<Database>& present) {
                return compareWith(*present, plan, staged);
            });
    removeAll(copy);
    if (!looked && isDamage(looked.error(), plan.library))
        return {};
    return looked;
}

/// The copy as this program would have written it.
Expected<void> examine(RestorePlan& plan, const CopyProgress& progress)
{
    {
        ASSIGN_OR_RETURN(const auto database, Database::open(plan.staged));
        ASSIGN_OR_RETURN(const int version, schemaVersion(*database));
        if (version == 0)
            return failure(ErrorCode::StorageOpen, {plan.backup, Words::tr("there is nothing in it")});
        RETURN_IF_ERROR(migrate(*database));
    }
    RETURN_IF_ERROR(foldIntoOneFile(plan.staged));
    const auto cancelled = failure(ErrorCode::Cancelled, {Words::tr("Putting back the backup")});
    if (!progress(1))
        return cancelled;
    ASSIGN_OR_RETURN(const LibraryVerification found, verifyLibraryCopy(plan.staged, {}));
    if (!found.whole())
        return failure(ErrorCode::StorageCorrupt, {plan.backup, inWords(found.differences.front())});
    ASSIGN_OR_RETURN(const auto database, Database::openToRead(plan.staged));
    ASSIGN_OR_RETURN(plan.holds, contentsOf(*database));
    RETURN_IF_ERROR(lookAtPresent(plan, *database));
    return progress(1) ? Expected<void>() : cancelled;
}

/// Beside the library, dated, and not there yet.
QString nameToKeep(const QString& library)
{
    const QFileInfo info(library);
    const QString folder = QDir(info.absolutePath()).canonicalPath(); // as the second place names it later
    const QString date = QDateTime::currentDateTimeUtc().toString(u"yyyyMMdd'T'HHmmss'Z'"_s);
    const QString suffix = info.suffix().isEmpty() ? QString() : u'.' + info.suffix();
    for (int again = 1;; ++again) {
        const QString number = again == 1 ? QString() : u"-%1"_s.arg(again);
        const QString name =
            u"%1/%2-before-restore-%3%4%5"_s.arg(folder, info.completeBaseName(), date, number, suffix);
        if (std::none_of(parts().begin(), parts().end(),
                         [&](const QString& part) { return QFileInfo::exists(name + part); }))
            return name;
    }
}

/// In the library that goes, while it can still refuse.
Expected<void> beginIn(const RestorePlan& plan, const Acting& acting, const QString& reason,
                       const QString& keptAs)
{
    RETURN_IF_ERROR(foldIntoOneFile(plan.library)); // nobody else has it open
    {
        ASSIGN_OR_RETURN(const auto database, Database::open(plan.library));
        RETURN_IF_ERROR(migrate(*database));
        database->actAs(acting);
        RETURN_IF_ERROR(writeTo<void>(*database, Words::tr("be put aside"), [&]() -> Expected<void> {
            RETURN_IF_ERROR(requirePermission(*database, Permission::RestoreLibrary));
            return audit_table::append(*database, {QString::fromUtf16(audit_action::libraryRestoreBegun),
                                                   plan.backup,
                                                   reason,
                                                   {{u"kept_as"_s, keptAs}}});
        }));
    }
    return foldIntoOneFile(plan.library);
}

/// In the copy, so that it tells of it from its first moment as the library.
Expected<AnnouncedRestore> tellIn(const RestorePlan& plan, const Acting& acting, const QString& reason,
                                  const QString& keptAs)
{
    const PassingLibrary passing(plan.staged); // the second place does not know it by this name
    AnnouncedRestore restore;
    {
        ASSIGN_OR_RETURN(const auto database, Database::open(plan.staged));
        RETURN_IF_ERROR(migrate(*database));
        ASSIGN_OR_RETURN(const auto before, ledger_table::ends(*database));
        database->actAs(acting);
        QJsonObject details{{u"kept_as"_s, keptAs}};
        if (plan.present)
            details.insert(u"inspections"_s, QJsonObject{{u"from"_s, plan.present->inspections},
                                                         {u"to"_s, plan.holds.inspections}});
        RETURN_IF_ERROR(writeTo<void>(*database, Words::tr("tell of the restore"), [&] {
            return audit_table::append(
                *database, {QString::fromUtf16(audit_action::libraryRestored), plan.backup, reason, details});
        }));
        restore.audit = database->newAuditHead();
        ASSIGN_OR_RETURN(restore.chains, ledger_table::ends(*database));
        for (const auto& [name, end] : restore.chains)
            if (const auto earlier = before.find(name); earlier == before.end() || earlier->second != end)
                restore.told = end;
    }
    RETURN_IF_ERROR(foldIntoOneFile(plan.staged));
    return restore;
}

/// All parts of a library, as far as they are there, get another name, or none does.
Expected<void> renameAll(const QString& from, const QString& to)
{
    QStringList moved;
    // What is beside it goes first: a log that stayed would be played into the next library.
    for (auto part = parts().crbegin(); part != parts().crend(); ++part) {
        QFile file(from + *part);
        if (!file.exists())
            continue;
        if (!file.rename(to + *part)) {
            const QString reason = file.errorString();
            for (const QString& back : moved)
                QFile::rename(to + back, from + back);
            return failure(ErrorCode::FileUnwritable, {to + *part, reason});
        }
        moved.append(*part);
    }
    return {};
}

Expected<void> swap(const RestorePlan& plan, const QString& keptAs)
{
    const QString next = nextInPlace(plan.library);
    QFile::remove(next); // of one that came to nothing
    QFile staged(plan.staged);
    if (!staged.rename(next))
        return failure(ErrorCode::FileUnwritable, {next, staged.errorString()});
    auto moved = renameAll(plan.library, keptAs);
    if (moved && finishSwap(plan.library)) {
        syncNames(plan.library);
        return {};
    }
    if (moved) {
        moved = failure(ErrorCode::FileUnwritable, {plan.library, Words::tr("it cannot be replaced")});
        static_cast<void>(renameAll(keptAs, plan.library));
    }
    QFile::remove(next);
    return moved;
}

/// What was announced has come to pass.
void settleWitness(const QString& library)
{
    if (const auto database = Database::openToRead(library))
        tellWitness(library, {}, [&](LibraryWitness& known) {
            settleRestore(known, ledger_table::hashesOf(**database));
            return true;
        });
}

Expected<QString> restore(const RestorePlan& plan, const Acting& acting, const QString& reason)
{
    if (reason.isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("Say why: the reason is kept with the change.")});
    const QString keptAs = nameToKeep(plan.library);
    if (plan.present)
        if (auto begun = beginIn(plan, acting, reason, keptAs);
            !begun && begun.error().code != ErrorCode::StorageCorrupt) // one that is damaged tells of nothing
            return tl::unexpected(begun.error());
    ASSIGN_OR_RETURN(const AnnouncedRestore announced, tellIn(plan, acting, reason, keptAs));
    RETURN_IF_ERROR(announceRestore(plan.library, keptAs, announced));
    RETURN_IF_ERROR(swap(plan, keptAs));
    settleWitness(plan.library);
    return keptAs;
}

} // namespace

Expected<RestorePlan> prepareRestore(const QString& library, const QString& backup,
                                     const CopyProgress& progress)
{
    if (const auto otherwise = putBackByServer(library, backup))
        return tl::unexpected(*otherwise);
    if (const auto identity = FileIdentity::of(library); identity && identity == FileIdentity::of(backup))
        return failure(ErrorCode::Usage, {Words::tr("This file is the library itself, not a copy of it.")});
    RestorePlan plan;
    plan.library = library;
    plan.backup = QFileInfo(backup).absoluteFilePath();
    plan.staged = library + u".restoring"_s;
    removeAll(plan.staged); // of one that was killed
    auto done = copyDatabase(backup, plan.staged, progress);
    if (done)
        done = examine(plan, progress);
    if (done)
        return plan;
    discard(plan);
    return tl::unexpected(aboutBackup(done.error(), plan));
}

void discard(const RestorePlan& plan)
{
    removeAll(plan.staged);
}

Expected<QString> restoreLibrary(const RestorePlan& plan, const Acting& acting, const QString& reason)
{
    auto keptAs = restore(plan, acting, reason.trimmed());
    if (!keptAs)
        discard(plan);
    return keptAs;
}

} // namespace gripscope
