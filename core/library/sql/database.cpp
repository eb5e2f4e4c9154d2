// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/database.h"

#include "core/base/bounded_file.h"
#include "core/base/printable.h"
#include "core/base/words.h"
#include "core/library/sql/unique_connection.h"

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

QString uniqueConnectionName()
{
    static std::atomic<quint64> counter{0};
    return u"gripscope-library-%1"_s.arg(++counter);
}

Database::Database(QString file, const SqlDialect& dialect, const QString& name)
    : m_file(std::move(file)), m_dialect(dialect),
      m_connection(QSqlDatabase::addDatabase(dialect.driver(), name))
{
}

Database::~Database()
{
    const QString name = m_connection.connectionName();
    closeConnection();
    m_connection = {}; // the last handle has to be gone before the name is given back
    QSqlDatabase::removeDatabase(name);
    m_inUse.reset();
}

Expected<std::unique_ptr<Database>> Database::connect(const QString& file, const QString& place,
                                                      const QString& parameters)
{
    const SqlDialect& sqlite = SqlDialect::sqlite();
    if (!QSqlDatabase::isDriverAvailable(sqlite.driver()))
        return failure(ErrorCode::StorageOpen, {file, sqlite.driverMissing()});
    QString name = place, options = u"QSQLITE_BUSY_TIMEOUT=%1"_s.arg(sqlBusyTimeout_ms);
    if (!parameters.isEmpty()) {
        const QByteArray url = QUrl::fromLocalFile(QFileInfo(place).absoluteFilePath()).toEncoded();
        name = QString::fromLatin1(url) + parameters;
        options += u";QSQLITE_OPEN_URI;QSQLITE_OPEN_READONLY"_s;
    }
    std::unique_ptr<Database> database(new Database(file, sqlite, uniqueConnectionName()));
    database->m_connection.setDatabaseName(name);
    database->m_connection.setConnectOptions(options);
    database->m_inUse = std::make_unique<FileInUse>(place);
    if (!database->m_connection.open())
        return failure(ErrorCode::StorageOpen,
                       {file, sqlite.failureOf(database->m_connection.lastError()).words});
    database->m_inUse->noteNew(place);
    for (const QString& setting : sqlite.settings())
        RETURN_IF_ERROR(database->execute(setting, Words::tr("be opened")));
    return database;
}

Expected<std::unique_ptr<Database>> Database::open(const QString& file, const std::shared_ptr<Hangup>& hangup)
{
    ASSIGN_OR_RETURN(const LibraryLocation location, LibraryLocation::parse(file));
    if (location.server())
        return connectToServer(location, false, hangup);
    if (const auto reason = reasonNotToOpen(file))
        return failure(ErrorCode::StorageOpen, {file, *reason});
    ASSIGN_OR_RETURN(auto database, connect(file, file));
    RETURN_IF_ERROR(refuseForeignPrograms(*database));
    return database;
}

Expected<std::unique_ptr<Database>> Database::openToRead(const QString& file)
{
    ASSIGN_OR_RETURN(const LibraryLocation location, LibraryLocation::parse(file));
    if (location.server())
        return connectToServer(location, true);
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
    RETURN_IF_ERROR(database->execute(database->m_dialect.onlyReading(), Words::tr("be opened")));
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
    if (isOnServer())
        return {}; // the server does it
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
        const bool busy = m_dialect.failureOf(query.lastError()).kind == SqlFailure::Kind::Busy;
        if (!busy || timer.elapsed() > sqlBusyTimeout_ms)
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

std::optional<Error> Database::whyNotStored(const QString& text, const QString& doing) const
{
    if (m_dialect.takesText(text))
        return {};
    return Error{ErrorCode::StorageFailed,
                 {doing, Words::tr("a text in it holds the sign NUL, which the server cannot store")}};
}

Expected<void> Database::execute(const QString& sql, const QString& doing)
{
    RETURN_IF_ERROR(reconnectIfLost());
    QSqlQuery query(m_connection);
    if (!query.exec(sql))
        return error(query.lastError(), doing);
    return {};
}

Expected<QStringList> Database::tables()
{
    RETURN_IF_ERROR(reconnectIfLost());
    QSqlQuery query(m_connection);
    QStringList names;
    if (!query.exec(m_dialect.tablesSql()))
        return error(query.lastError(), Words::tr("be read"));
    while (query.next())
        names.append(query.value(0).toString());
    return names;
}

tl::unexpected<Error> Database::error(const QSqlError& error, const QString& doing) const
{
    const SqlFailure found = m_dialect.failureOf(error);
    m_failed = m_inTransaction && isOnServer();
    switch (found.kind) {
    case SqlFailure::Kind::Corrupt:
        return failure(ErrorCode::StorageCorrupt, {m_file, found.words});
    case SqlFailure::Kind::CannotBe:
        return failure(ErrorCode::StorageOpen, {m_file, found.words});
    case SqlFailure::Kind::Lost:
        m_lost = true;
        break;
    default:
        break;
    }
    return failure(ErrorCode::StorageFailed, {doing, found.words});
}

} // namespace gripscope
