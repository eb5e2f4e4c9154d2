// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QVariant>

class QSqlError;

namespace gripscope {

/// What a failed statement or connection means.
struct SqlFailure {
    enum class Kind {
        Failed,   ///< this one; the connection is as it was
        Busy,     ///< another program holds the lock; it may be tried again
        Corrupt,  ///< what is stored is damaged
        CannotBe, ///< the file, or the server, cannot be opened
        Lost      ///< the connection is gone, and its transaction with it
    };
    Kind kind = Kind::Failed;
    QString words;
};

/// What SQLite and PostgreSQL do each their own way. All other SQL is the same, and means the same: texts are
/// compared and ordered by their bytes, LIKE takes A to Z for a to z, numbers come back to the last bit, and
/// rows have a number, rowid, in the order in which they were put in.
class SqlDialect {
public:
    [[nodiscard]] static const SqlDialect& sqlite();
    [[nodiscard]] static const SqlDialect& postgresql();
    virtual ~SqlDialect() = default;

    [[nodiscard]] virtual QString driver() const = 0; ///< Qt's name of it
    /// What Qt lacks where it has no such driver, for a person.
    [[nodiscard]] virtual QString driverMissing() const = 0;
    [[nodiscard]] virtual QString driverPackage() const = 0; ///< Debian's name of what brings it
    /// Once for each connection.
    [[nodiscard]] virtual QStringList settings() const = 0;
    /// From then on nothing is written through it.
    [[nodiscard]] virtual QString onlyReading() const = 0;

    /// A statement of a migration as this database takes it.
    [[nodiscard]] virtual QString ofMigration(const QString& statement) const = 0;
    /// A statement of the tables.
    [[nodiscard]] virtual QString spelled(const QString& sql) const = 0;
    /// The statement puts one row in: it answers with the number of the row, where Qt does not tell it.
    [[nodiscard]] virtual QString answersRowNumber() const = 0;
    /// Rows come one after another as they are asked for, several statements beside each other.
    [[nodiscard]] virtual bool streams() const = 0;
    /// A number to bind, to the last bit.
    [[nodiscard]] virtual QVariant bound(double number) const = 0;
    [[nodiscard]] virtual bool takesText(const QString& text) const = 0;
    /// At most so many are bound to one statement of several rows.
    [[nodiscard]] virtual std::size_t valuesOfStatement() const = 0;

    [[nodiscard]] virtual QString tablesSql() const = 0;
    /// Name and default, as SQL, of each column of the table that is bound, by name.
    [[nodiscard]] virtual QString columnsSql() const = 0;
    /// Type, name, table and definition of each part of the schema.
    [[nodiscard]] virtual QString partsSql() const = 0;

    [[nodiscard]] virtual QString beginReading() const = 0;
    /// The lock is taken at once, and held to the end: numbers are given to one writer at a time.
    [[nodiscard]] virtual QStringList beginWriting() const = 0;

    [[nodiscard]] virtual SqlFailure failureOf(const QSqlError& error) const = 0;

protected:
    SqlDialect() = default;
    SqlDialect(const SqlDialect&) = default;
    SqlDialect& operator=(const SqlDialect&) = default;
};

/// How long a statement waits for another process before it gives up; a squeeze takes milliseconds to store.
inline constexpr int sqlBusyTimeout_ms = 10'000;

} // namespace gripscope
