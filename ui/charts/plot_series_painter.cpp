// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_series_painter.h"

#include <QChart>
#include <QLineSeries>
#include <QPainter>
#include <QScatterSeries>
#include <QValueAxis>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gripscope {

namespace {

/// From the axes' numbers to the chart's pixels.
class AxisMap {
public:
    AxisMap(const QChart& chart, QAbstractSeries* series) : m_area(chart.plotArea())
    {
        for (const QAbstractAxis* axis : chart.axes(Qt::Horizontal, series))
            m_horizontal = qobject_cast<const QValueAxis*>(axis);
        for (const QAbstractAxis* axis : chart.axes(Qt::Vertical, series))
            m_vertical = qobject_cast<const QValueAxis*>(axis);
    }
    [[nodiscard]] bool valid() const
    {
        return m_horizontal && m_vertical && m_horizontal->max() > m_horizontal->min() &&
               m_vertical->max() > m_vertical->min();
    }
    [[nodiscard]] QPointF operator()(QPointF point) const
    {
        const double across = (point.x() - m_horizontal->min()) / (m_horizontal->max() - m_horizontal->min());
        const double up = (point.y() - m_vertical->min()) / (m_vertical->max() - m_vertical->min());
        return {m_area.left() + across * m_area.width(), m_area.bottom() - up * m_area.height()};
    }

private:
    QRectF m_area;
    const QValueAxis* m_horizontal = nullptr;
    const QValueAxis* m_vertical = nullptr;
};

/// The part of a line inside of `area` (Liang and Barsky 1984).
std::optional<QLineF> inside(const QLineF& line, const QRectF& area)
{
    double from = 0, to = 1;
    const auto cut = [&](double direction, double room) {
        if (direction == 0)
            return room >= 0;
        const double at = room / direction;
        if (direction < 0)
            from = std::max(from, at);
        else
            to = std::min(to, at);
        return from <= to;
    };
    if (!std::isfinite(line.dx()) || !std::isfinite(line.dy()) || !cut(-line.dx(), line.x1() - area.left()) ||
        !cut(line.dx(), area.right() - line.x1()) || !cut(-line.dy(), line.y1() - area.top()) ||
        !cut(line.dy(), area.bottom() - line.y1()))
        return std::nullopt;
    return QLineF(line.pointAt(from), line.pointAt(to));
}

void paintLine(QPainter& painter, const QLineSeries& series, const AxisMap& map, const QRectF& area)
{
    QPolygonF run;
    const auto flush = [&] {
        if (run.size() > 1)
            painter.drawPolyline(run);
        run.clear();
    };
    painter.setPen(series.pen());
    painter.setBrush(Qt::NoBrush);
    const QList<QPointF> points = series.points();
    for (qsizetype i = 1; i < points.size(); ++i) {
        const std::optional<QLineF> part = inside({map(points[i - 1]), map(points[i])}, area);
        if (!part) {
            flush();
            continue;
        }
        if (run.isEmpty() || run.back() != part->p1()) {
            flush();
            run << part->p1();
        }
        run << part->p2();
    }
    flush();
}

void paintMarker(QPainter& painter, QScatterSeries::MarkerShape shape, QPointF at, double radius)
{
    if (shape == QScatterSeries::MarkerShapeRectangle)
        painter.drawRect(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius));
    else if (shape == QScatterSeries::MarkerShapeTriangle)
        painter.drawPolygon(QPolygonF{
            {at + QPointF(0, -radius), at + QPointF(radius, radius), at + QPointF(-radius, radius)}});
    else
        painter.drawEllipse(at, radius, radius);
}

void paintPoints(QPainter& painter, const QScatterSeries& series, const AxisMap& map, const QRectF& area)
{
    painter.setPen(QPen(series.borderColor(), 1));
    painter.setBrush(series.color());
    const double radius = series.markerSize() / 2;
    for (const QPointF& point : series.points()) {
        const QPointF at = map(point);
        if (area.contains(at))
            paintMarker(painter, series.markerShape(), at, radius);
    }
}

} // namespace

void paintSeries(QPainter& painter, const QChart& chart)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (QAbstractSeries* series : chart.series()) {
        const AxisMap map(chart, series);
        if (!map.valid())
            continue;
        if (const auto* line = qobject_cast<const QLineSeries*>(series))
            paintLine(painter, *line, map, chart.plotArea());
        else if (const auto* scatter = qobject_cast<const QScatterSeries*>(series))
            paintPoints(painter, *scatter, map, chart.plotArea());
    }
    painter.restore();
}

} // namespace gripscope
