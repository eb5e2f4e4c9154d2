// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QWidget>

class QGridLayout;
class QLabel;

namespace gripscope {

class BudgetPanel;

/// What the error bars are worth: what would make them better, what they are made of, what else follows from
/// m, b and k.
class UncertaintyPanel : public QWidget {
    Q_OBJECT
public:
    explicit UncertaintyPanel(QWidget* parent = nullptr);

    void setIdentification(const Identification& identification, const QString& forceUnit,
                           const QString& positionUnit);

private:
    void showAdvice(const Identification& identification);
    void showBudget(const Identification& identification, const QString& forceUnit,
                    const QString& positionUnit);
    void showDerived(const Identification& identification);

    QLabel* m_adviceHead;
    QLabel* m_advice;
    QLabel* m_budgetHead;
    BudgetPanel* m_budget;
    QLabel* m_derivedHead;
    QGridLayout* m_derived;
};

} // namespace gripscope
