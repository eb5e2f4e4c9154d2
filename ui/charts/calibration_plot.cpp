// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/calibration_plot.h"

#include "core/calibration/calibration_figures.h"
#include "ui/format/channel_scale.h"
#include "ui/format/reference_words.h"
#include "ui/theme/theme.h"

#include <QScatterSeries>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

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

CheckTrendPlot::CheckTrendPlot(QWidget* parent) : PlotFrame(parent)
{
    constexpr QScatterSeries::MarkerShape shapes[] = {QScatterSeries::MarkerShapeTriangle,
                                                      QScatterSeries::MarkerShapeRectangle,
                                                      QScatterSeries::MarkerShapeCircle};
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        m_series[i] = new QScatterSeries(this);
        m_series[i]->setMarkerSize(10);
        m_series[i]->setMarkerShape(shapes[i]);
        attach(m_series[i]);
    }
    setTitle(tr("Error (% of tolerance)"));
    setHorizontalTitle(tr("Days"));
    setExportNames(tr("Checks on the reference object"), u"reference_checks"_s, tr("Days"));
    setEmptyText(tr("The errors of the checks over time appear here."));
    CheckTrendPlot::themeChanged();
}

void CheckTrendPlot::setChecks(const std::vector<ReferenceCheckRecord>& checks, const QDateTime& now)
{
    constexpr double millisecondsADay = 24.0 * 3600 * 1000;
    m_days.clear();
    double largest = 100;
    for (std::vector<double>& values : m_percent)
        values.clear();
    for (const ReferenceCheckRecord& check : checks) {
        m_days.push_back(-double(check.made.msecsTo(now)) / millisecondsADay);
        for (std::size_t i = 0; i < m_percent.size(); ++i) {
            const auto& stated = check.reference.stated[i];
            const auto& measured = check.measured[i];
            m_percent[i].push_back(stated && measured
                                       ? 100 * (measured->value - stated->value) / stated->tolerance
                                       : std::numeric_limits<double>::quiet_NaN());
            if (std::isfinite(m_percent[i].back()))
                largest = std::max(largest, std::abs(m_percent[i].back()));
        }
    }
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        QList<QPointF> points;
        for (std::size_t at = 0; at < m_days.size(); ++at)
            if (std::isfinite(m_percent[i][at]))
                points << QPointF(m_days[at], m_percent[i][at]);
        m_series[i]->replace(points);
    }
    setBand(checks.empty() ? std::nullopt : std::optional(PlotRange{-100, 100}), tr("tolerance"));
    constexpr double leastDays = 1;
    const double oldest = m_days.empty() ? leastDays : std::max(leastDays, -m_days.back());
    setWhole({-1.05 * oldest, 0.05 * oldest});
    setVertical({-1.3 * largest, 1.3 * largest});
    themeChanged();
}

PlotTable CheckTrendPlot::numbers() const
{
    const auto column = [](const std::vector<double>& values) {
        return std::make_shared<std::vector<double>>(values);
    };
    PlotTable table{{tr("Days"), column(m_days)}};
    for (std::size_t i = 0; i < m_percent.size(); ++i)
        table.push_back({tr("%1 (% of tolerance)").arg(ReferenceWords::quantity(i)), column(m_percent[i])});
    return table;
}

void CheckTrendPlot::themeChanged()
{
    PlotFrame::themeChanged();
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QColor colors[] = {tokens.model, tokens.position, tokens.force};
    const QString names[] = {tr("▲ m"), tr("■ b"), tr("● k")};
    std::vector<LegendEntry> legend;
    for (std::size_t i = m_series.size(); i-- > 0;) {
        m_series[i]->setColor(colors[i]);
        m_series[i]->setBorderColor(tokens.surface);
        if (m_series[i]->count() > 0)
            legend.push_back({names[i], colors[i], 0});
    }
    setLegend(std::move(legend));
}

} // namespace gripscope
