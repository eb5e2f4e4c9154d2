// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QWidget>

namespace gripscope {

class CorrelationPlot;
class TimePlot;

/// One identification as plots under each other: measured position with the model's, force, residuals with
/// their band, and their correlations. The first three share their time axis: a zoom in one is a zoom in all.
class FitPlots : public QWidget {
    Q_OBJECT
public:
    explicit FitPlots(QWidget* parent = nullptr);

    /// Shows what `estimator` found; without it (or without a model) the measurement alone.
    void show(const Identification& identification, Estimator estimator, const QString& forceUnit,
              const QString& positionUnit);
    using QWidget::show;
    void clear();

    [[nodiscard]] TimePlot* response() const { return m_response; }
    [[nodiscard]] TimePlot* force() const { return m_force; }
    [[nodiscard]] TimePlot* residuals() const { return m_residuals; }
    [[nodiscard]] CorrelationPlot* autocorrelations() const { return m_auto; }
    [[nodiscard]] CorrelationPlot* crossCorrelations() const { return m_cross; }

private:
    void showCorrelations(const Identification& identification, const Estimate* estimate);
    void linkTime();

    TimePlot* m_response;
    TimePlot* m_force;
    TimePlot* m_residuals;
    CorrelationPlot* m_auto;
    CorrelationPlot* m_cross;
};

/// Names of estimators for people: "output error", "ARX(2,1,1)".
[[nodiscard]] QString estimatorName(Estimator estimator);

} // namespace gripscope
