// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/calibration_plot.h"

#include "core/calibration/calibration_figures.h"
#include "ui/charts/channel_scale.h"
#include "ui/theme/theme.h"

#include <QScatterSeries>

#include <algorithm>
#include <cmath>

namespace gripscope {

CalibrationPlot::CalibrationPlot(QWidget* parent)
    : PlotFrame(parent), m_up(new QScatterSeries(this)), m_down(new QScatterSeries(this))
{
    for (QScatterSeries* series : {m_up, m_down}) {
        series->setMarkerSize(10);
        attach(series);
    }
    m_up->setMarkerShape(QScatterSeries::MarkerShapeTriangle);
    m_down->setMarkerShape(QScatterSeries::MarkerShapeRectangle);
    setExportNames(tr("Residuals of the calibration"), QStringLiteral("calibration_residuals"), tr("Load"));
    setEmptyText(tr("What is left of each reading beside the curve appears here as soon as there are enough "
                    "points."));
    CalibrationPlot::themeChanged();
}

void CalibrationPlot::setCalibration(const SensorCalibration& calibration,
                                     const CalibrationEvaluation& evaluation)
{
    m_unit = calibration.unit;
    m_loads.clear();
    m_readings.clear();
    m_residuals = evaluation.residuals;
    double largestLoad = 0;
    double largest = evaluation.expandedUncertainty;
    for (const CalibrationPoint& point : calibration.points) {
        m_loads.push_back(point.load);
        m_readings.push_back(point.reading);
        largestLoad = std::max(largestLoad, std::abs(point.load));
    }
    for (const double residual : m_residuals)
        largest = std::max(largest, std::abs(residual));
    const ChannelScale loads = channelScale(m_unit, largestLoad);
    const ChannelScale rest = channelScale(m_unit, largest);
    const std::vector<bool> ascending = ascendingPoints(calibration.points);
    QList<QPointF> up, down;
    for (std::size_t i = 0; i < m_residuals.size(); ++i)
        (ascending[i] ? up : down) << QPointF(loads.factor * m_loads[i], rest.factor * m_residuals[i]);
    m_up->replace(up);
    m_down->replace(down);
    setTitle(rest.title(tr("Residual")));
    setHorizontalTitle(loads.title(tr("Load")));
    const double band = rest.factor * evaluation.expandedUncertainty;
    setBand(PlotRange{-band, band}, tr("95 %"));
    const auto [least, most] = std::minmax_element(m_loads.begin(), m_loads.end());
    const double margin = 0.04 * (*most - *least);
    setWhole({loads.factor * (*least - margin), loads.factor * (*most + margin)});
    const double half = 1.3 * rest.factor * largest;
    setVertical({-half, half});
    themeChanged();
}

void CalibrationPlot::clear()
{
    m_loads.clear();
    m_readings.clear();
    m_residuals.clear();
    m_up->clear();
    m_down->clear();
    setBand(std::nullopt);
    setLegend({});
    update();
}

PlotTable CalibrationPlot::numbers() const
{
    const auto column = [](const std::vector<double>& values) {
        return std::make_shared<std::vector<double>>(values);
    };
    return {{tr("Load (%1)").arg(m_unit), column(m_loads)},
            {tr("Reading (%1)").arg(m_unit), column(m_readings)},
            {tr("Residual (%1)").arg(m_unit), column(m_residuals)}};
}

void CalibrationPlot::themeChanged()
{
    PlotFrame::themeChanged();
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_up->setColor(tokens.force);
    m_down->setColor(tokens.position);
    for (QScatterSeries* series : {m_up, m_down})
        series->setBorderColor(tokens.surface);
    if (!m_loads.empty())
        setLegend({{tr("▲ up"), tokens.force, 0}, {tr("■ down"), tokens.position, 0}});
}

} // namespace gripscope
