// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/comparison/model_comparison.h"
#include "ui/models/row_table_model.h"

#include <vector>

namespace gripscope {

/// The models of one squeeze, the best first: how much worse each one's criterion is, how far it moves m, b
/// or k, how well it follows the position when it runs free.
class ComparisonTableModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Model, Delta, Weight, Change, SimulationFit };
    static constexpr int columns = 5;

    using RowTableModel::RowTableModel;

    void setComparison(const ModelComparison& comparison);
    /// Header and full precision, for a spreadsheet.
    [[nodiscard]] QString toTsv() const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int section, int role) const override;

    struct Row {
        QString id, words;
        double delta = 0, weight = 0, change = 0;
        std::optional<double> simulationPercent;
    };
    [[nodiscard]] QString text(const Row& row, Column column) const;

    std::vector<Row> m_rows;
    QString m_criterion;
};

/// The name of a model for people: "Cubic spring".
[[nodiscard]] QString modelName(const QString& id);

} // namespace gripscope
