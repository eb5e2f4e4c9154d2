// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>

#include <vector>

namespace gripscope {

/// The paper's Table 1: a column a type, a row a trial, in each cell the number (from 1) of the cluster that
/// the squeeze fell into. A type without such a trial has an empty cell.
class ClusterTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr int SortRole = Qt::UserRole;
    using QAbstractTableModel::QAbstractTableModel;

    void setTable(const QStringList& types, const std::vector<std::vector<int>>& rows);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QStringList m_types;
    std::vector<std::vector<int>> m_rows;
};

} // namespace gripscope
