// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/uncertainty_budget.h"
#include "ui/models/row_table_model.h"

#include <array>
#include <vector>

namespace gripscope {

/// An uncertainty budget as a table: an effect a line with its standard uncertainties of m, b and k and its
/// shares of their variances; at the end the combined standard uncertainty and the half width of the
/// interval. Numbers are raw, in the units of the header; BudgetDelegate words them.
class BudgetTableModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Effect, Mass, Damping, Stiffness };
    static constexpr int columns = 4;
    enum Role {
        SortRole = Qt::UserRole, ///< the raw number
        ShareRole,               ///< of the parameter's variance, 0 to 1; invalid in the rows of sums
        WordsRole,               ///< below the effect's name
        SumRole,                 ///< bool: a row of sums
    };

    using RowTableModel::RowTableModel;

    void setBudget(const UncertaintyBudget& budget, const QString& forceUnit, const QString& positionUnit);
    void clear();
    /// Header, units and full precision, for a spreadsheet: SI where the channels allow it.
    [[nodiscard]] QString toTsv() const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    struct Row {
        QString id, name, words;
        bool sum = false;
        std::array<double, 3> uncertainties{}; ///< SI where the channels allow it
        std::array<double, 3> shares{};
    };
    std::vector<Row> m_rows;
    std::array<QString, 3> m_units, m_shownUnits;
    std::array<double, 3> m_factors{1, 1, 1};
};

/// The name of an effect for people: "Position noise".
[[nodiscard]] QString effectName(const QString& id);

} // namespace gripscope
