// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QTableView;

namespace gripscope {

class ComparisonTableModel;
class ValidationPanel;

/// Which model explains the squeeze, in one sentence and as a table; how it does on other data; and, where
/// the force repeats, what its periods tell.
class ModelPanel : public QWidget {
    Q_OBJECT
public:
    explicit ModelPanel(QWidget* parent = nullptr);

    void setIdentification(const Identification& identification, const QString& forceUnit,
                           const QString& positionUnit);
    void setComparison(const ModelComparison& comparison); ///< this part alone
    [[nodiscard]] ValidationPanel* validation() const { return m_validation; }

private:
    void setPeriods(const std::optional<PeriodicDiagnostics>& periods, const QString& forceUnit,
                    const QString& positionUnit);

    ComparisonTableModel* m_model;
    QLabel* m_sentence;
    QTableView* m_table;
    QLabel* m_note;
    ValidationPanel* m_validation;
    QWidget* m_periods;
    QLabel* m_periodWords;
    QGridLayout* m_periodFacts;
};

} // namespace gripscope
