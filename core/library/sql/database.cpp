// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/database.h"

#include "core/base/bounded_file.h"
#include "core/base/printable.h"
#include "core/base/words.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QThread>
#include <QUrl>

#include <atomic>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// How long a statement waits for another process before it gives up; a squeeze takes milliseconds to store.
constexpr int busyTimeout_ms = 10'000;

/// SQLite's primary result codes (sqlite.org/rescode.html).
enum SqliteCode {
    Busy = 5,
    Locked = 6,
    ReadOnly = 8,
    IoError = 10,
    Corrupt = 11,
    Full = 13,
    CantOpen = 14,
    NotADatabase = 26
};

int primaryCode(const QSqlError& error)
{
    return error.nativeErrorCode().toInt() & 0xff; // the higher bits only refine it
}

QString inWords(const QSqlError& error)
{
    switch (primaryCode(error)) {
    case Busy:
    case Locked:
        return Words::tr("another program kept it locked for %1 s").arg(busyTimeout_ms / 1000);
    case ReadOnly:
        return Words::tr("the file or its folder is write-protected");
    case IoError:
        return Words::tr("the disk reports an error");
    case Full:
        return Words::tr("the disk is full");
    case CantOpen:
        return Words::tr("the file or its folder is missing or may not be opened or written");
    default:
        return error.databaseText().isEmpty() ? error.driverText() : error.databaseText();
    }
}

/// So many as tell what kind of file it is; none of a library that this program has open.
Expected<QByteArray> firstBytes(const QString& name)
{
    Expected<QByteArray> bytes;
    FileInUse::unlessInUse(name, [&] {
        QFile file(name);
        bytes = openRegular(file).map([&file] { return file.read(16); });
    });
    return bytes;
}

bool areOfAnotherKind(const QByteArray& head)
{
    return !head.isEmpty() && head != QByteArray("SQLite format 3\0", 16);
}

/// Looks at the first bytes, so that a file of another kind is refused before SQLite touches it.
std::optional<QString> reasonNotToOpen(const QString& name)
{
    if (name.isEmpty())
        return Words::tr("no file is named");
    if (!QFileInfo::exists(name))
        return {};
    const Expected<QByteArray> head = firstBytes(name);
    if (!head)
        return head.error().argument(1);
    if (areOfAnotherKind(*head))
        return Words::tr("it is not a library but a file of another kind");
    return {};
}

/// What is half written is mended in a copy, not in place. False where this program has it open: nothing is.
Expected<bool> copyParts(const QString& file, const QString& copy)
{
    Expected<bool> copied = false;
    FileInUse::unlessInUse(file, [&] {
        copied = true;
        for (const QString& part : {u""_s, u"-wal"_s, u"-journal"_s})
            if (copied && QFileInfo::exists(file + part) && !QFile::copy(file + part, copy + part))
                copied =
                    failure(ErrorCode::StorageOpen,
                            {file, Words::tr("there is no room for the copy that it has to be read from")});
    });
    return copied;
}

QString uniqueConnectionName()
{
    static std::atomic<quint64> counter{0};
    return u"gripscope-library-%1"_s.arg(++counter);
}

/// StorageOpen where the file holds what acts by itself (triggers, views, virtual tables, computed columns):
/// no migration makes any, and a stored verdict must not become another on its way.
Expected<void> refuseForeignPrograms(const Database& database)
{
    // Views and virtual tables have no page of their own; a computed column is hidden.
    const QString find =
        u"SELECT type, name FROM sqlite_master WHERE type = 'trigger' OR (type IN ('table', 'view') AND rootpage = 0)"_s;
    const QString findComputed =
        u"SELECT 'column', m.name || '.' || x.name FROM sqlite_master m, pragma_table_xinfo(m.name) x "
        "WHERE m.type = 'table' AND x.hidden <> 0"_s;
    for (const QString& sql : {find, findComputed}) {
        QSqlQuery query(database.connection());
        if (!query.exec(sql))
            return database.error(query.lastError(), Words::tr("be read"));
        if (query.next())
            return failure(
                ErrorCode::StorageOpen,
                {database.file(),
                 Words::tr("it runs a program of its own, the %1 %2, which no library does")
                     .arg(query.value(0).toString(), printable(query.value(1).toString(), longestQuote))});
    }
    return {};
}

} // namespace

Database::Database(QString file, const QString& name)
    : m_file(std::move(file)), m_connection(QSqlDatabase::addDatabase(u"QSQLITE"_s, name))
{
}

Database::~Database()
{
    const QString name = m_connection.connectionName();
    m_connection.close();
    m_connection = {}; // the last handle has to be gone before the name is given back
    QSqlDatabase::removeDatabase(name);
    m_inUse.reset();
}

Expected<std::unique_ptr<Database>> Database::connect(const QString& file, const QString& place,
                                                      const QString& parameters)
{
    if (!QSqlDatabase::isDriverAvailable(u"QSQLITE"_s))
        return failure(ErrorCode::StorageOpen, {file, Words::tr("Qt's SQLite driver is not installed")});
    QString name = place, options = u"QSQLITE_BUSY_TIMEOUT=%1"_s.arg(busyTimeout_ms);
    if (!parameters.isEmpty()) {
        const QByteArray url = QUrl::fromLocalFile(QFileInfo(place).absoluteFilePath()).toEncoded();
        name = QString::fromLatin1(url) + parameters;
        options += u";QSQLITE_OPEN_URI;QSQLITE_OPEN_READONLY"_s;
    }
    std::unique_ptr<Database> database(new Database(file, uniqueConnectionName()));
    database->m_connection.setDatabaseName(name);
    database->m_connection.setConnectOptions(options);
    database->m_inUse = std::make_unique<FileInUse>(place);
    if (!database->m_connection.open())
        return failure(ErrorCode::StorageOpen, {file, inWords(database->m_connection.lastError())});
    database->m_inUse->noteNew(place);
    // With the usual 2 MB of pages a library of a hundred thousand squeezes is read from the disk again and
    // again.
    // The file may be anybody's: what its schema says is not run, and a cell that lies about its size is an
    // error.
    for (const QString& setting : {u"PRAGMA trusted_schema=OFF"_s, u"PRAGMA cell_size_check=ON"_s,
                                   u"PRAGMA foreign_keys=ON"_s, u"PRAGMA cache_size=-65536"_s})
        RETURN_IF_ERROR(database->execute(setting, Words::tr("be opened")));
    return database;
}

Expected<std::unique_ptr<Database>> Database::open(const QString& file)
{
    if (const auto reason = reasonNotToOpen(file))
        return failure(ErrorCode::StorageOpen, {file, *reason});
    ASSIGN_OR_RETURN(auto database, connect(file, file));
    RETURN_IF_ERROR(refuseForeignPrograms(*database));
    return database;
}

Expected<std::unique_ptr<Database>> Database::openToRead(const QString& file)
{
    if (const auto reason = reasonNotToOpen(file))
        return failure(ErrorCode::StorageOpen, {file, *reason});
    if (!QFileInfo::exists(file))
        return failure(ErrorCode::StorageOpen, {file, Words::tr("there is no such file")});
    const Written written = Written::of(file); // before it is known that nobody has it
    const bool log = QFileInfo::exists(file + u"-wal"_s);
    const bool inUse = log && QFileInfo::exists(file + u"-shm"_s);
    const bool halfWritten = QFileInfo::exists(file + u"-journal"_s) || (log && !inUse);
    std::unique_ptr<QTemporaryDir> copy;
    if (halfWritten) {
        copy = std::make_unique<QTemporaryDir>();
        ASSIGN_OR_RETURN(const bool copied, copyParts(file, copy->filePath(u"copy"_s)));
        if (!copied)
            copy.reset();
    }
    const QString place = copy ? copy->filePath(u"copy"_s) : file;
    const bool alone = !copy && !inUse;
    const QString readOnly = alone ? u"?immutable=1"_s : u"?mode=ro"_s;
    ASSIGN_OR_RETURN(auto database, connect(file, place, copy ? QString() : readOnly));
    database->m_copy = std::move(copy);
    if (alone)
        database->m_alone = written;
    RETURN_IF_ERROR(database->execute(u"PRAGMA query_only=ON"_s, Words::tr("be opened")));
    return database;
}

bool Database::isOfAnotherKind(const QString& file)
{
    const Expected<QByteArray> head = firstBytes(file);
    return head && areOfAnotherKind(*head);
}

Expected<std::unique_ptr<Database>> Database::inMemory()
{
    return connect({}, u":memory:"_s);
}

Database::Written Database::Written::of(const QString& file)
{
    const QFileInfo info(file);
    return {info.lastModified(), info.size()};
}

bool Database::wasWrittenMeanwhile() const
{
    // Who came and went has moved the log into the file, which is gone.
    return m_alone && (QFileInfo::exists(m_file + u"-wal"_s) || Written::of(m_file) != *m_alone);
}

Expected<void> Database::prepareForWriting()
{
    const QString doing = Words::tr("be opened for writing");
    QElapsedTimer timer;
    timer.start();
    while (true) {
        QSqlQuery query(m_connection);
        if (query.exec(u"PRAGMA journal_mode=WAL"_s) && query.next()) {
            if (query.value(0).toString() == "wal"_L1)
                break;
            return failure(ErrorCode::StorageOpen,
                           {m_file, Words::tr("its file system cannot keep a write-ahead log")});
        }
        // While another process makes the same change SQLite answers "busy" at once, without the timeout.
        const int code = primaryCode(query.lastError());
        if ((code != Busy && code != Locked) || timer.elapsed() > busyTimeout_ms)
            return error(query.lastError(), doing);
        QThread::msleep(5);
    }
    m_identity = FileIdentity::of(m_file);
    return execute(u"PRAGMA synchronous=FULL"_s, doing);
}

Expected<void> Database::requireSameFile(const QString& doing) const
{
    if (!m_identity || FileIdentity::of(m_file) == m_identity)
        return {};
    return failure(
        ErrorCode::StorageFailed,
        {doing, Words::tr("its file %1 was removed or replaced while it was open. Put it back where it "
                          "was; where that cannot be, close the program, put back a copy and start "
                          "again")
                    .arg(m_file)});
}

Expected<void> Database::execute(const QString& sql, const QString& doing)
{
    QSqlQuery query(m_connection);
    if (!query.exec(sql))
        return error(query.lastError(), doing);
    return {};
}

Expected<QStringList> Database::tables()
{
    QSqlQuery query(m_connection);
    QStringList names;
    if (!query.exec(u"SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name"_s))
        return error(query.lastError(), Words::tr("be read"));
    while (query.next())
        names.append(query.value(0).toString());
    return names;
}

tl::unexpected<Error> Database::error(const QSqlError& error, const QString& doing) const
{
    switch (primaryCode(error)) {
    case Corrupt:
    case NotADatabase:
        return failure(ErrorCode::StorageCorrupt, {m_file, error.databaseText()});
    case CantOpen:
        return failure(ErrorCode::StorageOpen, {m_file, inWords(error)});
    default:
        return failure(ErrorCode::StorageFailed, {doing, inWords(error)});
    }
}

Expected<std::unique_ptr<ReadTransaction>> ReadTransaction::begin(Database& database, const QString& doing)
{
    RETURN_IF_ERROR(database.execute(u"BEGIN"_s, doing));
    return std::unique_ptr<ReadTransaction>(new ReadTransaction(database, doing));
}

ReadTransaction::~ReadTransaction()
{
    static_cast<void>(m_database.execute(u"COMMIT"_s, m_doing)); // there is nothing that could be lost
}

Expected<std::unique_ptr<Transaction>> Transaction::begin(Database& database, const QString& doing)
{
    RETURN_IF_ERROR(database.requireSameFile(doing));
    RETURN_IF_ERROR(database.execute(u"BEGIN IMMEDIATE"_s, doing));
    return std::unique_ptr<Transaction>(new Transaction(database, doing));
}

Transaction::~Transaction()
{
    if (m_open) // an error here means that SQLite has rolled back by itself already
        static_cast<void>(m_database.execute(u"ROLLBACK"_s, m_doing));
}

Expected<void> Transaction::commit()
{
    auto done = m_database.execute(u"COMMIT"_s, m_doing);
    m_open = !done;
    return done ? m_database.requireSameFile(m_doing) : done;
}

} // namespace gripscope
