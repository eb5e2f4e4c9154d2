// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/row_table_model.h"

namespace gripscope {

int RowTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : length();
}

int RowTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : width();
}

QVariant RowTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const bool isColumn = orientation == Qt::Horizontal && section >= 0 && section < width();
    return isColumn ? head(section, role) : QVariant();
}

} // namespace gripscope
