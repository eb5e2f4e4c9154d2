// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QTabWidget;

namespace gripscope {

class CheckList;
class ElidedLabel;
class EstimateTableModel;
class EstimatorPanel;
class ModelPanel;
class RegionPlot;
class UncertaintyPanel;
class ValidationPanel;
class ValidityLine;

/// The right third of the Fit page. Always in view: what was squeezed, the verdict on the measurement, m, b
/// and k with their error bars. Behind tabs: the estimators against each other, the joint region, the checks,
/// what the uncertainty is made of, other models.
class FitSummary : public QWidget {
    Q_OBJECT
public:
    explicit FitSummary(QWidget* parent = nullptr);

    void show(const QString& title, const Identification& identification, const QString& forceUnit,
              const QString& positionUnit);
    using QWidget::show;
    [[nodiscard]] EstimateTableModel* table() const;
    [[nodiscard]] RegionPlot* regionPlot() const { return m_region; }
    [[nodiscard]] ValidationPanel* validation() const;
    void showValidation(const Validation& validation);

signals:
    void estimatorChosen(gripscope::Estimator estimator); ///< a row of the table

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* buildHead();
    void buildTabs();
    void addTab(QWidget* body, const QString& title);
    void showBest();

    Identification m_identification;
    QString m_forceUnit, m_positionUnit;
    ElidedLabel* m_title;
    ValidityLine* m_verdict;
    ElidedLabel* m_facts;
    QGridLayout* m_best;
    QTabWidget* m_tabs;
    EstimatorPanel* m_estimators;
    RegionPlot* m_region;
    QLabel* m_regionWords;
    CheckList* m_checks;
    UncertaintyPanel* m_uncertainty;
    ModelPanel* m_models;
};

} // namespace gripscope
