// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/uncertainty_budget.h"

#include <QWidget>

class QLabel;
class QTableView;

namespace gripscope {

class BudgetTableModel;

/// The uncertainty budget: a table of effects, and in words what the effect of the current row is.
class BudgetPanel : public QWidget {
    Q_OBJECT
public:
    explicit BudgetPanel(QWidget* parent = nullptr);

    void setBudget(const UncertaintyBudget& budget, const QString& forceUnit, const QString& positionUnit);
    [[nodiscard]] BudgetTableModel* model() const { return m_model; }

private:
    void showWords(int row);

    BudgetTableModel* m_model;
    QTableView* m_table;
    QLabel* m_words;
    QLabel* m_message;
};

} // namespace gripscope
