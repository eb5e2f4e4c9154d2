// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "core/calibration/sensor_calibration.h"
#include "ui/charts/plot_frame.h"

#include <array>
#include <vector>

class QScatterSeries;

namespace gripscope {

/// What is left of the readings beside the curve, against the load: points on the way up and on the way down
/// in shapes of their own, and the expanded uncertainty as a band.
class CalibrationPlot : public PlotFrame {
    Q_OBJECT
public:
    explicit CalibrationPlot(QWidget* parent = nullptr);

    void setCalibration(const SensorCalibration& calibration, const CalibrationEvaluation& evaluation);
    void clear();
    [[nodiscard]] PlotTable numbers() const override;

protected:
    void themeChanged() override;
    [[nodiscard]] bool empty() const override { return m_loads.empty(); }

private:
    QScatterSeries* m_up;
    QScatterSeries* m_down;
    std::vector<double> m_loads, m_readings, m_residuals;
    QString m_unit;
};

/// The checks on the reference object over time: the error of each of m, b, k in percent of its tolerance,
/// which is the band; a shape of its own for each.
class CheckTrendPlot : public PlotFrame {
    Q_OBJECT
public:
    explicit CheckTrendPlot(QWidget* parent = nullptr);
    void setChecks(const std::vector<ReferenceCheckRecord>& checks, const QDateTime& now);
    [[nodiscard]] PlotTable numbers() const override;

protected:
    void themeChanged() override;
    [[nodiscard]] bool empty() const override { return m_days.empty(); }

private:
    std::array<QScatterSeries*, 3> m_series;      ///< m, b, k
    std::vector<double> m_days;                   ///< from now, of each check
    std::array<std::vector<double>, 3> m_percent; ///< NaN where nothing was found
};

} // namespace gripscope
