// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/database_copy.h"

#include "core/base/words.h"
#include "core/library/sql/statement.h"

#include <QFile>
#include <QFileInfo>
#include <QSqlDriver>
#include <QThread>
#include <QVariant>

#include <algorithm>
#include <memory>
#include <sqlite3.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Some 200 kB: often enough to be cancelled at once.
constexpr int pagesAtOnce = 50;
/// The file is this program's own until it is done: only a virus scanner or the like holds it.
constexpr int busyPause_ms = 20, busyTries = 500;

QString copying()
{
    return Words::tr("be copied");
}

sqlite3* handleOf(const Database& database)
{
    const QVariant handle = database.connection().driver()->handle();
    const bool known = handle.isValid() && qstrcmp(handle.typeName(), "sqlite3*") == 0;
    return known ? *static_cast<sqlite3* const*>(handle.data()) : nullptr;
}

tl::unexpected<Error> copyFailure(const Database& target, sqlite3* handle, int code)
{
    switch (code & 0xff) {
    case SQLITE_FULL:
        return failure(ErrorCode::FileUnwritable, {target.file(), Words::tr("the disk is full")});
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
        return failure(ErrorCode::StorageCorrupt, {target.file(), QString::fromUtf8(sqlite3_errmsg(handle))});
    default:
        return failure(ErrorCode::FileUnwritable, {target.file(), QString::fromUtf8(sqlite3_errstr(code))});
    }
}

Expected<void> copyPages(const Database& source, const Database& target, const CopyProgress& progress)
{
    sqlite3* from = handleOf(source);
    sqlite3* to = handleOf(target);
    if (from == nullptr || to == nullptr)
        return failure(ErrorCode::StorageFailed,
                       {copying(), Words::tr("Qt's SQLite driver does not give its connection")});
    const std::unique_ptr<sqlite3_backup, int (*)(sqlite3_backup*)> backup(
        sqlite3_backup_init(to, "main", from, "main"), &sqlite3_backup_finish);
    if (!backup)
        return copyFailure(target, to, sqlite3_errcode(to));
    for (int waits = 0;;) {
        const int code = sqlite3_backup_step(backup.get(), pagesAtOnce);
        if (code == SQLITE_DONE)
            return {};
        if ((code == SQLITE_BUSY || code == SQLITE_LOCKED) && ++waits < busyTries)
            QThread::msleep(busyPause_ms);
        else if (code != SQLITE_OK)
            return copyFailure(target, to, code);
        const int all = std::max(1, sqlite3_backup_pagecount(backup.get()));
        if (!progress(1.0 - double(sqlite3_backup_remaining(backup.get())) / all))
            return failure(ErrorCode::Cancelled, {Words::tr("Copying the library")});
    }
}

/// True when it is of one state.
Expected<bool> copyOnce(const QString& from, const QString& to, const CopyProgress& progress)
{
    ASSIGN_OR_RETURN(const auto source, Database::openToRead(from));
    // One state from here on, whoever writes meanwhile; a transaction begins with what it reads first.
    RETURN_IF_ERROR(source->execute(u"BEGIN"_s, copying()));
    RETURN_IF_ERROR(source->tables());
    {
        ASSIGN_OR_RETURN(const auto target, Database::open(to));
        RETURN_IF_ERROR(copyPages(*source, *target, progress));
    }
    return !source->wasWrittenMeanwhile();
}

Expected<void> copyOfOneState(const QString& from, const QString& to, const CopyProgress& progress)
{
    constexpr int attempts = 3;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        ASSIGN_OR_RETURN(const bool whole, copyOnce(from, to, progress));
        if (whole)
            return foldIntoOneFile(to); // its first page says that there is a log beside it
        QFile::remove(to);
    }
    return failure(ErrorCode::StorageFailed,
                   {copying(), Words::tr("other programs opened it again and again meanwhile")});
}

} // namespace

Expected<void> copyDatabase(const QString& from, const QString& to, const CopyProgress& progress)
{
    if (QFileInfo::exists(to))
        return failure(ErrorCode::FileUnwritable, {to, Words::tr("there is a file of this name already")});
    auto done = copyOfOneState(from, to, progress);
    if (!done)
        for (const QString& rest : {u""_s, u"-journal"_s, u"-wal"_s, u"-shm"_s})
            QFile::remove(to + rest);
    return done;
}

Expected<void> foldIntoOneFile(const QString& file)
{
    ASSIGN_OR_RETURN(const auto database, Database::open(file));
    QString mode;
    {
        Statement query(*database, Words::tr("be taken out of use"), u"PRAGMA journal_mode=DELETE"_s);
        RETURN_IF_ERROR(query.forEach([&](Statement& row) { mode = row.takeText(); }));
    }
    if (mode == "delete"_L1)
        return {};
    return failure(ErrorCode::StorageFailed, {Words::tr("be taken out of use"),
                                              Words::tr("another program has it open, or this one still has. "
                                                        "Close the other one, then try again")});
}

} // namespace gripscope
