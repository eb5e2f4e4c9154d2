// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QScrollArea>

class QGridLayout;
class QLabel;
class QTableView;

namespace gripscope {

class CheckList;
class EstimateTableModel;

/// The right third of the Fit page: the recommended estimate with its error bars, the estimators against each
/// other, the checks on the measurement.
class FitSummary : public QScrollArea {
    Q_OBJECT
public:
    explicit FitSummary(QWidget* parent = nullptr);

    void show(const QString& title, const Identification& identification, const QString& forceUnit,
              const QString& positionUnit);
    using QWidget::show;
    [[nodiscard]] EstimateTableModel* table() const { return m_model; }
    /// Header and one line an estimator, tab-separated.
    [[nodiscard]] QString toTsv() const;

signals:
    void estimatorChosen(gripscope::Estimator estimator); ///< a row of the table

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildTable();
    void showBest();
    void fitTable();

    Identification m_identification;
    QString m_forceUnit, m_positionUnit;
    QLabel* m_title;
    QLabel* m_facts;
    QLabel* m_bestName;
    QGridLayout* m_best;
    EstimateTableModel* m_model;
    QTableView* m_table;
    QLabel* m_note;
    CheckList* m_checks;
};

} // namespace gripscope
