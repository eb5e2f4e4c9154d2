// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/cluster_table_model.h"

namespace gripscope {

void ClusterTableModel::setTable(const QStringList& types, const std::vector<std::vector<int>>& rows)
{
    beginResetModel();
    m_types = types;
    m_rows = rows;
    endResetModel();
}

int ClusterTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int ClusterTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_types.size());
}

QVariant ClusterTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignCenter);
    if (role != Qt::DisplayRole && role != Qt::EditRole && role != SortRole)
        return {};
    const std::vector<int>& row = m_rows[std::size_t(index.row())];
    const auto column = std::size_t(index.column());
    return column < row.size() && row[column] > 0 ? QVariant(row[column]) : QVariant();
}

QVariant ClusterTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignCenter);
    if ((role != Qt::DisplayRole && role != Qt::ToolTipRole) || section < 0)
        return {};
    if (orientation == Qt::Horizontal)
        return section < m_types.size() ? QVariant(m_types[section]) : QVariant();
    return section + 1;
}

} // namespace gripscope
