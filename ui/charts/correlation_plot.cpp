// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/correlation_plot.h"

#include "ui/theme/theme.h"

#include <QLineSeries>
#include <QScatterSeries>

#include <algorithm>
#include <cmath>

namespace gripscope {

CorrelationPlot::CorrelationPlot(QWidget* parent)
    : PlotFrame(parent), m_stems(new QLineSeries(this)), m_heads(new QScatterSeries(this))
{
    m_heads->setMarkerSize(5);
    attach(m_stems);
    attach(m_heads);
    setRubberBand(QChartView::NoRubberBand);
    CorrelationPlot::themeChanged();
}

void CorrelationPlot::setCorrelation(const Correlation& correlation)
{
    QList<QPointF> stems, heads;
    double largest = 0;
    m_outside = 0;
    const bool automatic = !correlation.lags.empty() && correlation.lags.front() == 0;
    for (std::size_t i = 0; i < correlation.lags.size(); ++i) {
        if (automatic && correlation.lags[i] == 0)
            continue; // always 1, and would press everything else flat
        const QPointF head(correlation.lags[i], correlation.values[i]);
        // One line that runs along zero and up each stem.
        stems << QPointF(head.x(), 0) << head << QPointF(head.x(), 0);
        heads << head;
        largest = std::max(largest, std::abs(head.y()));
        m_outside += std::abs(head.y()) > correlation.band ? 1 : 0;
    }
    m_stems->replace(stems);
    m_heads->replace(heads);
    m_empty = heads.isEmpty();
    if (m_empty) {
        setBand(std::nullopt);
        return;
    }
    setBand(PlotRange{-correlation.band, correlation.band}, tr("95 % band"));
    setWhole({heads.first().x() - 0.7, heads.last().x() + 0.7});
    const double half = std::min(1.05, 1.2 * std::max(largest, 1.5 * correlation.band));
    setVertical({-half, half});
    setAccessibleDescription(tr("%n lag(s) outside of the 95 % band", nullptr, m_outside));
}

void CorrelationPlot::themeChanged()
{
    PlotFrame::themeChanged();
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_stems->setPen(QPen(tokens.text, 0.75 * tokens.curveWidth));
    m_heads->setColor(tokens.text);
    m_heads->setBorderColor(tokens.text);
}

} // namespace gripscope
