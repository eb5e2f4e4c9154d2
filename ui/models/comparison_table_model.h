// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model_comparison.h"

#include <QAbstractTableModel>

#include <vector>

namespace gripscope {

/// The models of one squeeze, the best first: how much worse each one's criterion is, how far it moves m, b
/// or k, how well it follows the position when it runs free.
class ComparisonTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Model, Delta, Weight, Change, SimulationFit };
    static constexpr int columns = 5;

    using QAbstractTableModel::QAbstractTableModel;

    void setComparison(const ModelComparison& comparison);
    /// Header and full precision, for a spreadsheet.
    [[nodiscard]] QString toTsv() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
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
