// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

namespace gripscope {

/// The place of a row among those of its table, in all libraries of a plant: what "the newest" goes by.
/// Milliseconds since 1970 by the station's clock, but behind every row that the library knew when it was
/// stored (a hybrid logical clock: Kulkarni et al., OPODIS 2014). So what was stored in knowledge of another
/// row comes behind it whatever the clocks say, and what two stations stored apart goes by their clocks. Rows
/// of earlier programs were counted from 1; those from before there were places have 0 and go by their clock.

/// The next one, in SQL, for an INSERT.
[[nodiscard]] inline QString nextSerial(const QString& table)
{
    return QStringLiteral("(SELECT MAX(place) FROM (SELECT COALESCE(MAX(serial), 0) + 1 AS place FROM %1 "
                          "UNION ALL SELECT %2) AS places)")
        .arg(table, QString::number(QDateTime::currentMSecsSinceEpoch()));
}

/// For ORDER BY.
inline const QString newestFirst = QStringLiteral("serial DESC, created_utc DESC, id DESC");

} // namespace gripscope
