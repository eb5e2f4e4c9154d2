// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/correlation.h"
#include "ui/charts/plot_frame.h"

class QLineSeries;
class QScatterSeries;

namespace gripscope {

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

} // namespace gripscope
