// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_advice.h"

#include <QAbstractTableModel>

#include <optional>
#include <vector>

namespace gripscope {

/// What each criterion says of each number of clusters: a row a number, a column a criterion. The number
/// that a criterion is for is set in strong type and marked.
class AdviceTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Clusters, Silhouette, CalinskiHarabasz, DaviesBouldin, Gap, Bic };
    static constexpr int columns = 6;
    static constexpr int SortRole = Qt::UserRole;
    static constexpr int BestRole = Qt::UserRole + 1; ///< whether the column's criterion is for this row

    using QAbstractTableModel::QAbstractTableModel;

    void setAdvice(const ClusterAdvice& advice);
    void clear() { setAdvice({}); }
    /// Header and full precision, for a spreadsheet.
    [[nodiscard]] QString toTsv() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] std::optional<double> value(const ClusterFigures& figures, Column column) const;
    [[nodiscard]] bool best(const ClusterFigures& figures, Column column) const;
    [[nodiscard]] QString text(const ClusterFigures& figures, Column column) const;

    ClusterAdvice m_advice;
};

} // namespace gripscope
