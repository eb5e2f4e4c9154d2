// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_advice.h"
#include "ui/models/row_table_model.h"

#include <optional>
#include <vector>

namespace gripscope {

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
