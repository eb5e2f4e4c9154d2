// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "ui/charts/plot_frame.h"

#include <array>
#include <vector>

class QScatterSeries;

namespace gripscope {

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
