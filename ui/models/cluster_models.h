// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clustering/cluster_advice.h"
#include "core/clustering/cluster_agreement.h"
#include "ui/models/row_table_model.h"

#include <QAbstractTableModel>
#include <QStringList>

#include <optional>
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

/// How many squeezes of each type fell into each cluster: a row a type, a column a cluster.
class ClusterCountsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr int SortRole = Qt::UserRole;
    using QAbstractTableModel::QAbstractTableModel;

    void setAgreement(const ClusterAgreement& agreement);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    ClusterAgreement m_agreement;
};

/// What each criterion says of each number of clusters: a row a number, a column a criterion. The number
/// that a criterion is for is set in strong type and marked.
class AdviceTableModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Clusters, Silhouette, CalinskiHarabasz, DaviesBouldin, Gap, Bic };
    static constexpr int columns = 6;
    static constexpr int SortRole = Qt::UserRole;
    static constexpr int BestRole = Qt::UserRole + 1; ///< whether the column's criterion is for this row

    using RowTableModel::RowTableModel;

    void setAdvice(const ClusterAdvice& advice);
    void clear() { setAdvice({}); }
    /// Header and full precision, for a spreadsheet.
    [[nodiscard]] QString toTsv() const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_advice.figures.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] std::optional<double> value(const ClusterFigures& figures, Column column) const;
    [[nodiscard]] bool best(const ClusterFigures& figures, Column column) const;
    [[nodiscard]] QString text(const ClusterFigures& figures, Column column) const;

    ClusterAdvice m_advice;
};

} // namespace gripscope
