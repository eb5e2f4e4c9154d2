// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/bode_plots.h"
#include "ui/theme/theme.h"

#include <QChart>
#include <QLineSeries>
#include <QPainter>
#include <QScatterSeries>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gripscope {

namespace {

constexpr double paleColor = 0.45; ///< of a doubtful point on the surface

std::shared_ptr<const std::vector<double>> sharedColumn(const std::vector<double>& values)
{
    return std::make_shared<const std::vector<double>>(values);
}

/// A vertical line that is cut off at the plot's edges, also where there is no clip.
void paintInterval(QPainter& painter, QPointF low, QPointF high, const QRectF& area)
{
    const double top = std::max(high.y(), area.top()), bottom = std::min(low.y(), area.bottom());
    if (low.x() >= area.left() && low.x() <= area.right() && top < bottom)
        painter.drawLine(QPointF(low.x(), top), QPointF(low.x(), bottom));
}

} // namespace

void FrequencyCurve::append(double frequency, double at)
{
    frequency_Hz.push_back(frequency);
    value.push_back(at);
}

void FrequencyCurve::append(double frequency, double at, double from, double to)
{
    append(frequency, at);
    low.push_back(from);
    high.push_back(to);
}

FrequencyPlot::FrequencyPlot(QWidget* parent)
    : PlotFrame(parent), m_line(new QLineSeries(this)), m_points(new QScatterSeries(this)),
      m_pale(new QScatterSeries(this))
{
    m_points->setMarkerSize(5);
    m_pale->setMarkerSize(4);
    attach(m_pale);
    attach(m_points);
    attach(m_line);
    setLogarithmic(Qt::Horizontal);
    FrequencyPlot::themeChanged();
}

void FrequencyPlot::setLogarithmicValues()
{
    m_logarithmicValues = true;
    setLogarithmic(Qt::Vertical);
}

double FrequencyPlot::drawn(double value) const
{
    return m_logarithmicValues ? std::log10(value) : value;
}

void FrequencyPlot::fill(QXYSeries& series, const FrequencyCurve& curve) const
{
    QList<QPointF> points;
    for (std::size_t i = 0; i < curve.value.size(); ++i)
        if (std::isfinite(drawn(curve.value[i])))
            points.append({std::log10(curve.frequency_Hz[i]), drawn(curve.value[i])});
    series.replace(points);
}

void FrequencyPlot::setCurves(FrequencyCurve model, FrequencyCurve measured, FrequencyCurve doubtful)
{
    m_model = std::move(model);
    m_measured = std::move(measured);
    m_doubtful = std::move(doubtful);
    fill(*m_line, m_model);
    fill(*m_points, m_measured);
    fill(*m_pale, m_doubtful);
    viewport()->update();
}

bool FrequencyPlot::empty() const
{
    return m_model.value.empty() && m_measured.value.empty() && m_doubtful.value.empty();
}

void FrequencyPlot::fitVertical()
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    const auto widen = [&](double value) {
        if (!std::isfinite(drawn(value)))
            return;
        low = std::min(low, drawn(value));
        high = std::max(high, drawn(value));
    };
    const bool onlyDoubtful = m_model.value.empty() && m_measured.value.empty();
    for (const FrequencyCurve* curve : {&m_model, &m_measured})
        std::for_each(curve->value.begin(), curve->value.end(), widen);
    if (onlyDoubtful)
        std::for_each(m_doubtful.value.begin(), m_doubtful.value.end(), widen);
    if (!(high >= low))
        return;
    const double half = std::max((high - low) / 2 * 1.1, m_logarithmicValues ? 0.1 : 1e-9);
    setVertical({(low + high) / 2 - half, (low + high) / 2 + half});
}

QPolygonF FrequencyPlot::band() const
{
    QPolygonF upper, lower;
    for (std::size_t i = 0; i < m_model.low.size(); ++i) {
        const double x = std::log10(m_model.frequency_Hz[i]);
        const QPointF low = pixelOf({x, drawn(m_model.low[i])}), high = pixelOf({x, drawn(m_model.high[i])});
        if (!std::isfinite(low.y()) || !std::isfinite(high.y()))
            continue;
        upper << high;
        lower << low;
    }
    std::reverse(lower.begin(), lower.end());
    return upper + lower;
}

void FrequencyPlot::drawBackground(QPainter* painter, const QRectF& rect)
{
    PlotFrame::drawBackground(painter, rect);
    if (empty())
        return;
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QRectF area = chart()->plotArea();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (const QPolygonF shape = band(); shape.size() > 2) {
        painter->setPen(Qt::NoPen);
        painter->setBrush(Theme::mix(tokens.surface, tokens.model, 0.3));
        painter->drawPolygon(shape.intersected(QPolygonF(area))); // cut by geometry: SVG files have no clip
    }
    painter->setPen(QPen(Theme::mix(tokens.surface, tokens.position, 0.7), 1));
    for (std::size_t i = 0; i < m_measured.low.size(); ++i) {
        const double x = std::log10(m_measured.frequency_Hz[i]);
        const QPointF low = pixelOf({x, drawn(m_measured.low[i])});
        const QPointF high = pixelOf({x, drawn(m_measured.high[i])});
        if (std::isfinite(low.y()) && std::isfinite(high.y()))
            paintInterval(*painter, low, high, area);
    }
    painter->restore();
}

void FrequencyPlot::themeChanged()
{
    PlotFrame::themeChanged();
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_line->setPen(QPen(tokens.model, 0.75 * tokens.curveWidth));
    m_points->setColor(tokens.position);
    m_points->setBorderColor(tokens.position);
    m_pale->setColor(tokens.surface);
    m_pale->setBorderColor(Theme::mix(tokens.surface, tokens.position, paleColor));
}

PlotTable FrequencyPlot::numbers() const
{
    PlotTable table;
    const auto add = [&](const FrequencyCurve& curve, const QString& name) {
        if (curve.value.empty())
            return;
        table.push_back({tr("Frequency (Hz)"), sharedColumn(curve.frequency_Hz)});
        table.push_back({name.arg(title()), sharedColumn(curve.value)});
        if (curve.low.empty())
            return;
        table.push_back({tr("from, 95 %"), sharedColumn(curve.low)});
        table.push_back({tr("to, 95 %"), sharedColumn(curve.high)});
    };
    add(m_measured, tr("%1, measured"));
    add(m_doubtful, tr("%1, measured, coherence too low"));
    add(m_model, tr("%1, model"));
    return table;
}

} // namespace gripscope
