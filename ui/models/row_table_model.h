// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include <optional>

namespace gripscope {

/// A list of rows whose columns have names: what a view asks of every such table, so that each says only how
/// long and wide it is, what its cells hold and what stands above them.
class RowTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const final;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const final;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const final;

protected:
    [[nodiscard]] virtual int length() const = 0; ///< in rows
    [[nodiscard]] virtual int width() const = 0;  ///< in columns
    /// Above a column, which is one of this table's.
    [[nodiscard]] virtual QVariant head(int column, int role) const = 0;
};

/// The data of a cell: no number is an empty cell.
[[nodiscard]] inline QVariant optionalNumber(const std::optional<double>& number)
{
    return number ? QVariant(*number) : QVariant();
}

} // namespace gripscope
