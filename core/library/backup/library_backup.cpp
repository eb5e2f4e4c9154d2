// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/backup/library_backup.h"

#include "core/base/words.h"
#include "core/library/backup/server_copies.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/sql/database.h"
#include "core/library/sql/synced_names.h"

#include <QFile>
#include <QFileInfo>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Under a name that nobody takes for a copy before it is one.
Expected<LibraryBackup> copyAndVerify(const QString& library, const QString& part,
                                      const CopyProgress& progress)
{
    // Before the copy: what is added meanwhile is only more.
    const LibraryWitness witness = readWitness(library);
    RETURN_IF_ERROR(copyDatabase(library, part, progress));
    if (!progress(1))
        return failure(ErrorCode::Cancelled, {Words::tr("Copying the library")});
    LibraryBackup backup;
    ASSIGN_OR_RETURN(backup.verified, verifyLibraryCopy(part, witness));
    ASSIGN_OR_RETURN(backup.contents, contentsOfLibrary(part));
    if (!progress(1))
        return failure(ErrorCode::Cancelled, {Words::tr("Copying the library")});
    return backup;
}

} // namespace

Expected<LibraryBackup> backUpLibrary(const QString& library, const QString& copy,
                                      const CopyProgress& progress)
{
    if (const auto otherwise = copiedByServer(library, copy))
        return tl::unexpected(*otherwise);
    const QString part = copy + u".part"_s;
    if (QFileInfo::exists(copy))
        return failure(ErrorCode::FileUnwritable,
                       {copy, Words::tr("there is a file of this name already, which is not overwritten")});
    QFile::remove(part); // of one that was killed
    auto backup = copyAndVerify(library, part, progress);
    // Refuses where there is such a file by now.
    QFile file(part);
    if (backup && !file.rename(copy))
        backup = failure(ErrorCode::FileUnwritable, {copy, file.errorString()});
    if (backup)
        syncNames(copy);
    else
        QFile::remove(part);
    return backup;
}

Expected<LibraryContents> contentsOfLibrary(const QString& file)
{
    ASSIGN_OR_RETURN(const auto database, Database::openToRead(file));
    return contentsOf(*database);
}

QString backupName(const QString& library, const QDate& today)
{
    const QFileInfo info(library);
    const QString suffix = info.suffix().isEmpty() ? u"db"_s : info.suffix();
    return u"%1-%2.%3"_s.arg(info.completeBaseName(), today.toString(Qt::ISODate), suffix);
}

} // namespace gripscope
