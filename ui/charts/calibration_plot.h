// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/sensor_calibration.h"
#include "ui/charts/plot_frame.h"

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

} // namespace gripscope
