// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// The place of a row among those of its table, in the order they came: what "the newest" goes by, whatever
/// the clock of a station says. Rows from before there were places have 0 and go by their clock.

/// The next one, in SQL, for an INSERT.
[[nodiscard]] inline QString nextSerial(const QString& table)
{
    return QStringLiteral("(SELECT COALESCE(MAX(serial), 0) + 1 FROM %1)").arg(table);
}

/// For ORDER BY.
inline const QString newestFirst = QStringLiteral("serial DESC, created_utc DESC, id DESC");

} // namespace gripscope
