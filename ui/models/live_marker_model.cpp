// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/live_marker_model.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

void LiveMarkerModel::add(LiveMarker marker)
{
    if (m_markers.size() >= static_cast<std::size_t>(most))
        remove(0);
    marker.number = ++m_lastNumber;
    const auto place =
        std::upper_bound(m_markers.begin(), m_markers.end(), marker.time_s,
                         [](double time_s, const LiveMarker& other) { return time_s < other.time_s; });
    const int row = static_cast<int>(place - m_markers.begin());
    beginInsertRows({}, row, row);
    m_markers.insert(place, std::move(marker));
    endInsertRows();
}

void LiveMarkerModel::remove(int row)
{
    if (row < 0 || row >= rowCount())
        return;
    beginRemoveRows({}, row, row);
    m_markers.erase(m_markers.begin() + row);
    endRemoveRows();
}

void LiveMarkerModel::clear()
{
    beginResetModel();
    m_markers.clear();
    m_lastNumber = 0;
    endResetModel();
}

QVariant LiveMarkerModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const LiveMarker& marker = m_markers[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<Column>(index.column());
    if (role == Qt::TextAlignmentRole)
        return QVariant(column == Column::Number ? Qt::AlignRight | Qt::AlignVCenter
                                                 : Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    switch (column) {
    case Column::Number:
        return marker.number;
    case Column::When:
        return role == Qt::EditRole ? QVariant(marker.when) : marker.when.toString(u"HH:mm:ss.zzz"_s);
    case Column::Words:
        return marker.words;
    }
    return {};
}

QVariant LiveMarkerModel::head(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (static_cast<Column>(column)) {
    case Column::Number:
        return tr("No.");
    case Column::When:
        return tr("Time");
    case Column::Words:
        return tr("Words");
    }
    return {};
}

Qt::ItemFlags LiveMarkerModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags base = QAbstractTableModel::flags(index);
    return index.column() == static_cast<int>(Column::Words) ? base | Qt::ItemIsEditable : base;
}

bool LiveMarkerModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid) ||
        index.column() != static_cast<int>(Column::Words))
        return false;
    m_markers[static_cast<std::size_t>(index.row())].words = value.toString().simplified();
    emit dataChanged(index, index, {Qt::DisplayRole, Qt::EditRole});
    return true;
}

} // namespace gripscope
