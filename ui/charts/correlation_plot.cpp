// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/correlation_plot.h"

#include "ui/theme/theme.h"

#include <QLineSeries>
#include <QScatterSeries>

#include <algorithm>
#include <cmath>

namespace gripscope {

CorrelationPlot::CorrelationPlot(QWidget* parent)
    : PlotFrame(parent), m_stems(new QLineSeries(this)), m_heads(new QScatterSeries(this)),
      m_outsideHeads(new QScatterSeries(this))
{
    m_heads->setMarkerSize(4);
    m_outsideHeads->setMarkerSize(7);
    attach(m_stems);
    attach(m_heads);
    attach(m_outsideHeads);
    setRubberBand(QChartView::NoRubberBand);
    CorrelationPlot::themeChanged();
}

void CorrelationPlot::setCorrelation(const Correlation& correlation, double sampleTime_s)
{
    m_correlation = correlation;
    m_sampleTime_s = sampleTime_s;
    QList<QPointF> stems, heads, outside;
    const double lag_ms = 1000 * sampleTime_s;
    double largest = 0;
    std::pair<double, double> ends{HUGE_VAL, -HUGE_VAL};

    const bool automatic = !correlation.lags.empty() && correlation.lags.front() == 0;
    for (std::size_t i = 0; i < correlation.lags.size(); ++i) {
        if (automatic && correlation.lags[i] == 0)
            continue; // always 1, and would press everything else flat
        const QPointF head(correlation.lags[i] * lag_ms, correlation.values[i]);
        // One line that runs along zero and up each stem.
        stems << QPointF(head.x(), 0) << head << QPointF(head.x(), 0);
        (std::abs(head.y()) > correlation.band ? outside : heads) << head;
        ends.first = std::min(ends.first, head.x());
        ends.second = std::max(ends.second, head.x());
        largest = std::max(largest, std::abs(head.y()));
    }
    m_stems->replace(stems);
    m_heads->replace(heads);
    m_outsideHeads->replace(outside);
    m_lagsOutside = int(outside.size());
    m_empty = stems.isEmpty();
    if (m_empty) {
        setBand(std::nullopt);
        return;
    }
    setBand(PlotRange{-correlation.band, correlation.band}, tr("95 % band"));
    setWhole({ends.first - 0.7 * lag_ms, ends.second + 0.7 * lag_ms});
    const double half = std::min(1.05, 1.2 * std::max(largest, 1.5 * correlation.band));
    setVertical({-half, half});
    setAccessibleDescription(tr("%n lag(s) outside of the 95 % band", nullptr, m_lagsOutside));
}

PlotTable CorrelationPlot::numbers() const
{
    using Values = std::vector<double>;
    const auto lags = std::make_shared<Values>(m_correlation.lags.begin(), m_correlation.lags.end());
    const auto lags_ms = std::make_shared<Values>(*lags);
    for (double& lag : *lags_ms)
        lag *= 1000 * m_sampleTime_s;
    const auto band = std::make_shared<Values>(lags->size(), m_correlation.band);
    return {{tr("Lag (samples)"), lags},
            {tr("Lag (ms)"), lags_ms},
            {tr("Correlation"), std::make_shared<Values>(m_correlation.values)},
            {tr("95 % band (half width)"), band}};
}

void CorrelationPlot::themeChanged()
{
    PlotFrame::themeChanged();
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_stems->setPen(QPen(tokens.text, 0.75 * tokens.curveWidth));
    m_heads->setColor(tokens.text);
    m_heads->setBorderColor(tokens.text);
    m_outsideHeads->setColor(tokens.notValid);
    m_outsideHeads->setBorderColor(tokens.surface);
}

} // namespace gripscope
