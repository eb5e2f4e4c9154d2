// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/math/correlation.h"
#include "ui/charts/plot_frame.h"

#include <QPen>
#include <QWidget>

#include <memory>
#include <optional>

class QLineSeries;
class QScatterSeries;

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
    bool held = false; ///< each value stays until the next one: drawn in steps
    /// One of several alike, told apart by colour and dashes in place of the role's.
    std::optional<int> place = {};
    /// `y` in the unit of `column`, where the person reads another one; null: it is `y` itself.
    std::shared_ptr<const std::vector<double>> table = {};
};

/// Of the n-th of several curves alike: eight colours, from the ninth on dashed, from the 17th dotted.
[[nodiscard]] QPen placePen(int place);

/// Curves over time, drawn with at most two points a pixel column whatever their length.
class TimePlot : public PlotFrame {
    Q_OBJECT
public:
    explicit TimePlot(QWidget* parent = nullptr);

    void setCurves(std::vector<PlotCurve> curves);
    [[nodiscard]] const std::vector<PlotCurve>& curves() const { return m_curves; }
    /// Shows all from 0 to this, below half a second along an axis in milliseconds. Curves and tables stay in
    /// seconds.
    void setDuration(double end_s);
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
    [[nodiscard]] PlotRange inView_s() const;

    std::vector<PlotCurve> m_curves;
    double m_perSecond = 1; ///< of the axis
    std::vector<QLineSeries*> m_series;
};

/// Correlation against lag (in milliseconds) as stems, with the 95 % band behind them.
class CorrelationPlot : public PlotFrame {
    Q_OBJECT
public:
    explicit CorrelationPlot(QWidget* parent = nullptr);

    void setCorrelation(const Correlation& correlation, double sampleTime_s = 0);
    /// Lags (other than 0 of an autocorrelation) whose value is beyond the band.
    [[nodiscard]] int lagsOutside() const { return m_lagsOutside; }
    /// Lag in samples and in milliseconds, correlation, half width of the band.
    [[nodiscard]] PlotTable numbers() const override;

protected:
    void themeChanged() override;
    [[nodiscard]] bool empty() const override { return m_empty; }

private:
    QLineSeries* m_stems;
    QScatterSeries* m_heads;
    QScatterSeries* m_outsideHeads; ///< beyond the band: larger, and in the colour of a doubtful measurement
    Correlation m_correlation;
    double m_sampleTime_s = 0;
    bool m_empty = true;
    int m_lagsOutside = 0;
};

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

} // namespace gripscope
