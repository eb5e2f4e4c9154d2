// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace gripscope {

/// SELECT of the values of a column, each once, in a time that grows with how many values there are and not
/// with the rows: an index that begins with the column leads from each to the next.
[[nodiscard]] QString distinctSql(const QString& table, const QString& column);

/// A search for a text in all that a squeeze is found by, along indexes: as many conditions on a row would
/// read every row. Where few values stand in many rows (operators, grippers, types, batches) the values are
/// searched, each once; where there is one a row (part numbers, numbers) an index that holds nothing else is.
/// An index of words would find whole words only, and one of their pieces would take more room than the
/// squeezes' own rows; nor does a library hold virtual tables.
struct TextSearch {
    QString sql;        ///< SELECT of a column `id`: keys of squeezes, some of them twice, `most` at the most
    QStringList values; ///< to be bound to it
};
[[nodiscard]] TextSearch searchFor(const QString& text, qint64 most);

/// The pattern that containsSql() compares with.
[[nodiscard]] QString containedPattern(const QString& text);

} // namespace gripscope
