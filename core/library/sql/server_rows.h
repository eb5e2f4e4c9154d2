// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database.h"

#include <QSqlQuery>

#include <optional>
#include <string_view>
#include <vector>

namespace gripscope {

/// What RowCursor reads from a server: by a cursor there, some at first and then a thousand at a time, so
/// that neither a look-up nor a million rows cost more than they have to. Within a transaction.
class ServerRows {
public:
    ServerRows(Database& database, QString doing, const QString& sql);
    ~ServerRows();
    ServerRows(const ServerRows&) = delete;
    ServerRows& operator=(const ServerRows&) = delete;

    void restart(std::initializer_list<std::string_view> texts);
    bool next();
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }
    [[nodiscard]] std::string_view text(int column) const;
    [[nodiscard]] qint64 integer(int column) const;
    [[nodiscard]] std::optional<double> real(int column) const;

private:
    bool fetch();
    void close();
    Database& m_database;
    QString m_doing, m_sql, m_name;
    QSqlQuery m_rows;
    mutable std::vector<QByteArray> m_texts; ///< of the row it stands on, as far as they were asked for
    int m_atOnce = 0, m_left = 0;
    bool m_declared = false;
    std::optional<Error> m_error;
};

} // namespace gripscope
