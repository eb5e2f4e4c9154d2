// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database.h"

#include <QByteArray>
#include <QDateTime>
#include <QSqlQuery>

#include <functional>
#include <optional>

namespace gripscope {

/// One prepared SQL statement: values are bound in the order of its question marks, columns taken in the
/// order of its SELECT list.
class Statement {
public:
    Statement(Database& database, QString doing, const QString& sql);

    Statement& bind(const QString& text);
    Statement& bind(double number);
    Statement& bind(const std::optional<double>& number);
    Statement& bind(qint64 number);
    Statement& bind(int number) { return bind(qint64(number)); }
    Statement& bind(bool) = delete;
    Statement& bind(const char*) = delete;
    Statement& bindBytes(const QByteArray& bytes);
    Statement& bindOrNull(const QString& text); ///< NULL when empty
    // NULL when there is none.
    Statement& bindOptional(const std::optional<qint64>& number);
    Statement& bindOptional(const std::optional<QString>& text);

    [[nodiscard]] Expected<void> run();
    /// Calls `row` for each row; take...() inside it. An error on the way ends it.
    [[nodiscard]] Expected<void> forEach(const std::function<void(Statement&)>& row);

    QString takeText();
    std::optional<QString> takeOptionalText();
    double takeReal();
    std::optional<double> takeOptionalReal();
    qint64 takeInteger();
    std::optional<qint64> takeOptionalInteger();
    QByteArray takeBytes();
    QDateTime takeUtc();

private:
    [[nodiscard]] bool prepare(const QString& sql);
    void refuseUnlessTaken(const QString& text);
    Database& m_database;
    QString m_doing;
    QString m_insertsInto; ///< a table; empty where it does something else
    QSqlQuery m_query;
    bool m_prepared = false;
    std::optional<Error> m_problem; ///< why it is not run
    int m_column = 0;
};

/// What every row carries: its key, the station it was written at and when.
struct RowStamp {
    QString id, station, utc;
    [[nodiscard]] static RowStamp now();
};

/// "2024-05-31T12:00:00.000Z": sorts as text, reads the same in every database.
[[nodiscard]] QString utcText(const QDateTime& time);

/// Host name and a few digits of the machine's own number, so that two hosts of one name stay apart.
[[nodiscard]] QString stationId();

} // namespace gripscope
