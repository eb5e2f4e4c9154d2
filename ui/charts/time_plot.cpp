// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/decimation.h"
#include "ui/charts/fit_plots.h"
#include "ui/theme/theme.h"

#include <QChart>
#include <QLineSeries>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gripscope {

namespace {

QPen curvePen(CurveRole role)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const auto pen = [](const QColor& color, double width) {
        return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    switch (role) {
    case CurveRole::MeasuredPosition:
        return pen(Theme::mix(tokens.surface, tokens.position, 0.55), 2.25 * tokens.curveWidth);
    case CurveRole::Model:
        return pen(tokens.model, 0.75 * tokens.curveWidth);
    case CurveRole::Force:
        return pen(tokens.force, 0.75 * tokens.curveWidth);
    case CurveRole::Residual:
        return pen(tokens.text, 0.5 * tokens.curveWidth);
    }
    return pen(tokens.text, 1);
}

QPen penOf(const PlotCurve& curve)
{
    return curve.place ? placePen(*curve.place) : curvePen(curve.role);
}

/// The part of a curve in [low, high], with the neighbours outside so that lines run to the edges.
std::pair<std::size_t, std::size_t> visiblePart(const std::vector<double>& x, PlotRange range)
{
    const auto first = std::lower_bound(x.begin(), x.end(), range.low);
    const auto last = std::upper_bound(first, x.end(), range.high);
    const auto from = std::size_t(first - x.begin());
    const auto to = std::size_t(last - x.begin());
    return {from > 0 ? from - 1 : 0, std::min(x.size(), to + 1)};
}

/// The values of a curve in the rows of another one's times; nothing (not a number) where it has none.
std::shared_ptr<const std::vector<double>> onTime(const PlotCurve& curve, const PlotCurve& times)
{
    const auto& y = curve.table ? curve.table : curve.y;
    const bool whole = !curve.missing || curve.missing->empty();
    if (!curve.x || !curve.y || curve.x->empty() || (whole && curve.x->size() == times.x->size()))
        return y;
    const auto first = std::lower_bound(times.x->begin(), times.x->end(), curve.x->front());
    const auto offset = std::size_t(first - times.x->begin());
    auto values = std::make_shared<std::vector<double>>(times.x->size(), std::nan(""));
    for (std::size_t i = 0; i < y->size() && offset + i < values->size(); ++i)
        (*values)[offset + i] = (*y)[i];
    for (std::size_t i = 0; !whole && i < curve.missing->size(); ++i)
        if (offset + (*curve.missing)[i] < values->size())
            (*values)[offset + (*curve.missing)[i]] = std::nan("");
    return values;
}

} // namespace

QPen placePen(int place)
{
    constexpr int colors = 8;
    constexpr std::array styles{Qt::SolidLine, Qt::DashLine, Qt::DotLine};
    const ThemeTokens& tokens = Theme::instance().tokens();
    // Made for a light surface; on a dark one they are lifted.
    const QColor color =
        Theme::mix(Theme::typeColor(place), tokens.text, tokens.kind == ThemeKind::Light ? 0.0 : 0.35);
    return {color, 0.75 * tokens.curveWidth, styles[std::size_t(std::max(0, place)) / colors % styles.size()],
            Qt::FlatCap, Qt::RoundJoin};
}

TimePlot::TimePlot(QWidget* parent) : PlotFrame(parent) {}

void TimePlot::setCurves(std::vector<PlotCurve> curves)
{
    m_curves = std::move(curves);
    while (m_series.size() > m_curves.size()) {
        chart()->removeSeries(m_series.back());
        delete m_series.back();
        m_series.pop_back();
    }
    while (m_series.size() < m_curves.size()) {
        m_series.push_back(new QLineSeries(this));
        attach(m_series.back());
    }
    themeChanged();
    refresh();
}

void TimePlot::setDuration(double end_s)
{
    constexpr double shortest_s = 0.5; ///< its numbers would begin with zeros
    m_perSecond = end_s < shortest_s ? 1000 : 1;
    renameHorizontal(m_perSecond > 1 ? tr("Time (ms)") : tr("Time (s)"));
    setWhole({0, m_perSecond * std::max(end_s, 1e-9)});
    showWhole();
    refresh();
}

PlotRange TimePlot::inView_s() const
{
    return {horizontal().low / m_perSecond, horizontal().high / m_perSecond};
}

bool TimePlot::empty() const
{
    return std::all_of(m_curves.begin(), m_curves.end(),
                       [](const PlotCurve& c) { return !c.y || c.y->empty(); });
}

int TimePlot::drawnPoints() const
{
    int points = 0;
    for (const QLineSeries* series : m_series)
        points += int(series->count());
    return points;
}

void TimePlot::refresh()
{
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const PlotCurve& curve = m_curves[i];
        QList<QPointF> points;
        if (curve.x && curve.y) {
            const auto [from, to] = visiblePart(*curve.x, inView_s());
            const std::span<const double> x(curve.x->data() + from, to - from);
            const std::span<const double> y(curve.y->data() + from, to - from);
            const std::vector<PlotPoint> few = decimateMinMax(x, y, std::size_t(columns()));
            points.reserve(qsizetype(few.size()) * (curve.held ? 2 : 1));
            for (const PlotPoint& point : few) {
                if (curve.held && !points.isEmpty())
                    points.append({m_perSecond * point.x, points.back().y()});
                points.append({m_perSecond * point.x, point.y});
            }
        }
        m_series[i]->replace(points);
    }
    viewport()->update();
}

void TimePlot::fitVertical(double leastHalf)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const PlotCurve& curve : m_curves) {
        if (!curve.x || !curve.y)
            continue;
        const auto [from, to] = visiblePart(*curve.x, inView_s());
        for (std::size_t i = from; i < to; ++i) {
            low = std::min(low, (*curve.y)[i]);
            high = std::max(high, (*curve.y)[i]);
        }
    }
    if (!(high >= low))
        return;
    const double middle = (low + high) / 2;
    // What does not move at all stands in a range that gives its value away.
    const double least = high > low ? std::abs(middle) * 1e-9 : std::abs(middle) * 0.1;
    const double half = std::max({(high - low) / 2 * 1.06, leastHalf, least, 1e-300});
    setVertical({middle - half, middle + half});
}

PlotTable TimePlot::numbers() const
{
    PlotTable table;
    for (const PlotCurve& curve : m_curves) {
        if (table.empty())
            table.push_back({tr("Time (s)"), curve.x});
        table.push_back({curve.column.isEmpty() ? title() : curve.column, onTime(curve, m_curves.front())});
    }
    return table;
}

void TimePlot::updateLegend()
{
    std::vector<LegendEntry> entries;
    for (const PlotCurve& curve : m_curves) {
        const QPen pen = penOf(curve);
        entries.push_back({curve.name, pen.color(), std::max(2, int(std::lround(pen.widthF())))});
    }
    setLegend(std::move(entries));
}

void TimePlot::themeChanged()
{
    PlotFrame::themeChanged();
    for (std::size_t i = 0; i < m_series.size(); ++i)
        m_series[i]->setPen(penOf(m_curves[i]));
    updateLegend();
}

} // namespace gripscope
