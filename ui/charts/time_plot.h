// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_frame.h"

#include <memory>

class QLineSeries;

namespace gripscope {

/// How a curve is drawn: a measured one broad and pale, so that the model's thin line shows on top of it.
enum class CurveRole { MeasuredPosition, Model, Force, Residual };

/// A curve over time in shown units. Data is shared, not copied: charts only look at it.
struct PlotCurve {
    QString name;
    CurveRole role = CurveRole::MeasuredPosition;
    std::shared_ptr<const std::vector<double>> x, y;
    QString column = {}; ///< of an exported table: "Measured position (mm)"
    /// Indexes at which `y` was not measured; tables leave these fields empty.
    std::shared_ptr<const std::vector<std::size_t>> missing = {};
};

/// Curves over time, drawn with at most two points a pixel column whatever their length.
class TimePlot : public PlotFrame {
    Q_OBJECT
public:
    explicit TimePlot(QWidget* parent = nullptr);

    void setCurves(std::vector<PlotCurve> curves);
    [[nodiscard]] const std::vector<PlotCurve>& curves() const { return m_curves; }
    /// Points that are drawn now, over all curves.
    [[nodiscard]] int drawnPoints() const;
    /// Fits the vertical range to what is in view; at least `leastHalf` either side of the middle.
    void fitVertical(double leastHalf = 0);
    /// Time (that of the first curve), then a column each curve: everything, not only what is in view.
    [[nodiscard]] PlotTable numbers() const override;

protected:
    void refresh() override;
    void themeChanged() override;
    [[nodiscard]] bool empty() const override;

private:
    void updateLegend();

    std::vector<PlotCurve> m_curves;
    std::vector<QLineSeries*> m_series;
};

} // namespace gripscope
