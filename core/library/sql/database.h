// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/sql/file_identity.h"
#include "core/library/sql/library_location.h"
#include "core/library/sql/sql_dialect.h"
#include "core/library/sql/table_rows.h"
#include "core/people/acting.h"
#include "core/people/audit_chain.h"

#include <QDateTime>
#include <QSqlDatabase>
#include <QString>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>

class QSqlError;
class QTemporaryDir;

namespace gripscope {

class Hangup;

/// A row that the open transaction has put in.
struct InsertedRow {
    QString table;
    qint64 rowNumber = 0;
};

/// One connection to a library, for the thread that opened it: to its file, or to the server that has it.
/// What SQLite and PostgreSQL do each their own way is in SqlDialect; what a connection needs, here.
///
/// The server may end a connection at any time, which only a statement that fails tells. A transaction that
/// was open has failed then, and nothing of it is stored; what is asked for next connects again.
class Database {
public:
    /// Opens or creates the file and changes nothing in it; or connects to the server (LibraryLocation),
    /// where the database has to be there. `hangup`: ends what waits for a server. StorageOpen,
    /// StorageCorrupt.
    [[nodiscard]] static Expected<std::unique_ptr<Database>> open(const QString& place,
                                                                  const std::shared_ptr<Hangup>& hangup = {});
    /// A file to look at: nothing is written, not beside it either. What another process is writing, or left
    /// behind half written, is seen as it stood. Its schema may be anybody's (schemaDifferences()), and its
    /// views are not to be read before that was looked at. StorageOpen, StorageCorrupt.
    [[nodiscard]] static Expected<std::unique_ptr<Database>> openToRead(const QString& place);
    /// Of openToRead(): nobody had it open then, and somebody has since, or had. What was read may be of two
    /// states.
    [[nodiscard]] bool wasWrittenMeanwhile() const;
    /// Its first bytes are not those of a library's file.
    [[nodiscard]] static bool isOfAnotherKind(const QString& file);
    /// An empty one that goes with its object.
    [[nodiscard]] static Expected<std::unique_ptr<Database>> inMemory();
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// Write-ahead log and full synchronisation. The log lets a reader go on while another process writes;
    /// FULL because a squeeze that was reported as stored must survive a power cut, and one flush a squeeze
    /// is cheap.
    [[nodiscard]] Expected<void> prepareForWriting();
    /// StorageFailed where the name no longer leads to the file that was prepared for writing: what is
    /// written would be lost.
    [[nodiscard]] Expected<void> requireSameFile(const QString& doing) const;

    [[nodiscard]] Expected<void> execute(const QString& sql, const QString& doing);
    [[nodiscard]] Expected<QStringList> tables();
    [[nodiscard]] const SqlDialect& dialect() const { return m_dialect; }
    [[nodiscard]] bool isOnServer() const { return m_server.has_value(); }
    /// What rows that are never deleted are sorted by to come in the order in which they were put in; a copy
    /// keeps it.
    [[nodiscard]] static QString orderOfInsertion() { return QStringLiteral("rowid"); }
    /// The condition that a text contains what is bound, '!' before a sign that stands for itself. SQLite's
    /// LIKE takes A to Z for a to z by itself; to lower both sides would take as long again.
    [[nodiscard]] static QString containsSql(const QString& text)
    {
        return text + QStringLiteral(" LIKE ? ESCAPE '!'");
    }

    /// The error as a value. `doing` completes "the library could not ...".
    [[nodiscard]] tl::unexpected<Error> error(const QSqlError& error, const QString& doing) const;
    /// StorageFailed: the text cannot be stored. Nothing: it can.
    [[nodiscard]] std::optional<Error> whyNotStored(const QString& text, const QString& doing) const;
    /// Connects again where the connection was lost and no transaction was under way. StorageOpen: it cannot.
    [[nodiscard]] Expected<void> reconnectIfLost();
    /// error() has been given one that ended the connection, and reconnectIfLost() has not mended it yet.
    [[nodiscard]] bool isLost() const { return m_lost; }

    [[nodiscard]] const QSqlDatabase& connection() const { return m_connection; }
    /// The file, or the address without a password.
    [[nodiscard]] QString file() const { return m_file; }

    /// Who works through this connection.
    void actAs(const Acting& acting) { m_acting = acting; }
    [[nodiscard]] const Acting& acting() const { return m_acting; }
    /// Where the audit trail ends by what was written in the open transaction; nothing where it was not
    /// continued.
    void setNewAuditHead(std::optional<AuditHead> head) { m_newAuditHead = std::move(head); }
    [[nodiscard]] const std::optional<AuditHead>& newAuditHead() const { return m_newAuditHead; }

    /// What Statement::run() put in since the transaction began, or since it was taken last, in that order.
    /// What an earlier transaction left, stored or not, is none of this one's.
    void noteInserted(InsertedRow row) { m_inserted.push_back(std::move(row)); }
    [[nodiscard]] std::vector<InsertedRow> takeInserted() { return std::exchange(m_inserted, {}); }
    /// What columnsOf() has read; to be emptied by whoever changes the tables.
    [[nodiscard]] std::map<QString, std::vector<Column>>& knownColumns() { return m_knownColumns; }

private:
    friend class Transaction;
    friend class ReadTransaction;
    /// What of a file tells that it was written to.
    struct Written {
        QDateTime changed;
        qint64 bytes = 0;
        [[nodiscard]] static Written of(const QString& file);
        friend bool operator==(const Written&, const Written&) = default;
    };
    Database(QString file, const SqlDialect& dialect, const QString& name);
    [[nodiscard]] static Expected<std::unique_ptr<Database>>
    connectToServer(const LibraryLocation& location, bool toRead, const std::shared_ptr<Hangup>& hangup = {});
    [[nodiscard]] Expected<void> openConnection();
    void closeConnection();
    /// Begins a transaction; where the connection turns out to be lost, on a new one.
    [[nodiscard]] Expected<void> begin(const QStringList& statements, const QString& doing);
    [[nodiscard]] Expected<void> commit(const QString& doing);
    void rollBack(const QString& doing);
    /// `place`: where what is called `file` is read. `parameters`: of a URI, to read only.
    [[nodiscard]] static Expected<std::unique_ptr<Database>>
    connect(const QString& file, const QString& place, const QString& parameters = {});
    std::unique_ptr<QTemporaryDir> m_copy; ///< holds what is read, where that is a copy
    std::unique_ptr<FileInUse> m_inUse;
    std::optional<Written> m_alone;         ///< as it was when nobody had it open
    std::optional<FileIdentity> m_identity; ///< from prepareForWriting() on
    QString m_file;
    const SqlDialect& m_dialect;
    std::optional<ServerAddress> m_server;
    std::shared_ptr<Hangup> m_hangup;
    int m_socket = -1; ///< that m_hangup knows
    bool m_toRead = false;
    mutable bool m_lost = false;   ///< the connection, and nobody has connected again yet
    mutable bool m_failed = false; ///< a statement of the transaction that is open on a server
    bool m_inTransaction = false;
    QSqlDatabase m_connection;
    Acting m_acting;
    std::optional<AuditHead> m_newAuditHead;
    std::vector<InsertedRow> m_inserted;
    std::map<QString, std::vector<Column>> m_knownColumns;
};

/// All that is read while it lives is of one state, whoever writes meanwhile.
class ReadTransaction {
public:
    [[nodiscard]] static Expected<std::unique_ptr<ReadTransaction>> begin(Database& database,
                                                                          const QString& doing);
    ~ReadTransaction();
    ReadTransaction(const ReadTransaction&) = delete;
    ReadTransaction& operator=(const ReadTransaction&) = delete;

private:
    ReadTransaction(Database& database, QString doing) : m_database(database), m_doing(std::move(doing)) {}
    Database& m_database;
    QString m_doing;
};

/// A write transaction that takes its lock at once: one that starts as a reader and then wants to write fails
/// without waiting when another process was quicker. Rolled back unless committed. Before and after it the
/// file has to be the one that its name leads to.
class Transaction {
public:
    [[nodiscard]] static Expected<std::unique_ptr<Transaction>> begin(Database& database,
                                                                      const QString& doing);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    [[nodiscard]] Expected<void> commit();
    /// commit() failed, and on a server it may have been done all the same: the connection ended before it
    /// answered. Nothing is open any more.
    [[nodiscard]] bool isAnswerLost() const { return m_answerLost; }

private:
    Transaction(Database& database, QString doing) : m_database(database), m_doing(std::move(doing)) {}
    Database& m_database;
    QString m_doing;
    bool m_open = true;
    bool m_answerLost = false;
};

} // namespace gripscope
