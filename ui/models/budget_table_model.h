// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "ui/models/row_table_model.h"

#include <QStringList>
#include <QStyledItemDelegate>

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

/// A row of BudgetTableModel: the effect's name; a number with its share of the variance as a bar below it.
class BudgetDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// What one effect (the id of its line in the uncertainty budget) has in the variances of m, b and k, 0 to 1.
struct ErrorShare {
    QString effect;
    std::array<double, 3> share{};
};

struct ImprovementFacts {
    std::array<double, 3> relativeHalfWidths{}; ///< of the 95 % intervals of m, b, k
    double naturalFrequency_Hz = 0;
    std::vector<ErrorShare> shares; ///< empty: noise is all that is known
};

/// What would make m, b and k better, the worst first: at most three sentences, each with what to do. Effects
/// count that hold at least half of a parameter's variance.
[[nodiscard]] QStringList improvementAdvice(const ImprovementFacts& facts);

/// For the recommended estimate. Nothing when the measurement is invalid: the failed checks say what to do
/// then; nothing without error bars.
[[nodiscard]] QStringList improvementAdvice(const Identification& identification);

} // namespace gripscope
