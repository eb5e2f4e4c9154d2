// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_frame.h"
#include "ui/theme/theme.h"

#include <QChart>
#include <QLineSeries>
#include <QPainter>
#include <QScatterSeries>
#include <QValueAxis>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

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

/// Paints the line and scatter series of a chart with two value axes, cut off at the plot area by geometry.
/// Charts cut them off by a clip, which SVG files do not get.
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

} // namespace

void PlotFrame::paintPicture(QPainter& painter)
{
    m_inPicture = true;
    const bool ownAxis = m_horizontalTitle.isEmpty() && !m_pictureAxis.isEmpty();
    if (ownAxis)
        setHorizontalTitle(m_pictureAxis);
    chart()->layout()->activate();
    const QList<QAbstractSeries*> series = chart()->series();
    for (QAbstractSeries* one : series)
        one->setVisible(false); // painted below, cut off without a clip
    const QRect all = viewport()->rect();
    render(&painter, all, all);
    for (QAbstractSeries* one : series)
        one->setVisible(true);
    paintSeries(painter, *chart());
    if (ownAxis)
        setHorizontalTitle({});
    chart()->layout()->activate(); // before the screen is painted again
    m_inPicture = false;
}

void PlotFrame::drawBackground(QPainter* painter, const QRectF& rect)
{
    QChartView::drawBackground(painter, rect);
    if (!m_band || empty())
        return;
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QRectF area = chart()->plotArea();
    const double y0 = chart()->mapToPosition({m_horizontal->min(), m_band->high}).y();
    const double y1 = chart()->mapToPosition({m_horizontal->min(), m_band->low}).y();
    const QRectF stripe = QRectF(QPointF(area.left(), y0), QPointF(area.right(), y1)).intersected(area);
    painter->save();
    painter->fillRect(stripe, Theme::mix(tokens.surface, tokens.accent, 0.12));
    painter->setPen(QPen(tokens.accent, tokens.lineWidth, Qt::DashLine));
    for (const double y : {y0, y1})
        if (y >= area.top() && y <= area.bottom())
            painter->drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter->restore();
}

double PlotFrame::paintTitle(QPainter* painter, const QRectF& line) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QFont strong = Theme::font(metrics::fontSmall, true), plain = Theme::font(metrics::fontSmall);
    const QFont& found = m_findingDoubtful ? strong : plain;
    const double findingWidth =
        m_finding.isEmpty() ? 0 : QFontMetricsF(found).horizontalAdvance(m_finding) + 7;
    const auto width = [&](const QString& title) { return QFontMetricsF(strong).horizontalAdvance(title); };
    QString title = m_finding.isEmpty() ? m_title : m_title + u':';
    // Where it is tight the short title; where that is too long, from the edge of the plot's own margin.
    QRectF room = line;
    if (width(title) + findingWidth > room.width())
        title = m_finding.isEmpty() ? m_briefTitle : m_briefTitle + u':';
    if (width(title) + findingWidth > room.width())
        room.setLeft(std::max(8.0, room.right() - width(title) - findingWidth));
    title =
        QFontMetricsF(strong).elidedText(title, Qt::ElideRight, std::max(0.0, room.width() - findingWidth));
    painter->setFont(strong);
    painter->setPen(tokens.text);
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, title);
    const double end = room.left() + width(title);
    if (m_finding.isEmpty())
        return end;
    painter->setFont(found);
    painter->setPen(m_findingDoubtful ? tokens.notValid : tokens.secondText);
    painter->drawText(room.adjusted(width(title) + 6, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, m_finding);
    return end + findingWidth;
}

void PlotFrame::paintHeader(QPainter* painter) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QRectF area = chart()->plotArea();
    const QRectF line(area.left(), 2, area.width(), headerHeight - 6);
    const double titleEnd = paintTitle(painter, line) + 16;
    painter->setFont(Theme::font(metrics::fontSmall));
    const QFontMetricsF small(painter->font());
    double end = line.right();
    const auto entry = [&](const QString& name, const auto& paintSign) {
        const double width = small.horizontalAdvance(name);
        if (name.isEmpty() || end - width - 24 < titleEnd)
            return;
        painter->setPen(tokens.secondText);
        painter->drawText(QRectF(end - width, line.top(), width + 1, line.height()),
                          Qt::AlignLeft | Qt::AlignVCenter, name);
        paintSign(QPointF(end - width - 24, line.center().y()));
        end -= width + 40;
    };
    if (!m_horizontalTitle.isEmpty()) {
        painter->setPen(tokens.secondText);
        painter->drawText(QRectF(0, area.bottom() + 4, area.left() - 14, 18),
                          Qt::AlignRight | Qt::AlignVCenter, m_horizontalTitle);
    }
    if (m_band)
        entry(m_bandName, [&](QPointF at) {
            painter->fillRect(QRectF(at.x(), at.y() - 4, 18, 8),
                              Theme::mix(tokens.surface, tokens.accent, 0.25));
        });
    for (auto i = m_legend.rbegin(); i != m_legend.rend(); ++i)
        entry(i->name, [&](QPointF at) {
            painter->setPen(QPen(i->color, i->width, Qt::SolidLine, Qt::FlatCap));
            painter->drawLine(at, at + QPointF(18, 0));
        });
}

void PlotFrame::drawForeground(QPainter* painter, const QRectF&)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter->save();
    paintHeader(painter);
    if (empty()) {
        painter->setPen(tokens.secondText);
        painter->setFont(Theme::font(metrics::fontSmall));
        painter->drawText(chart()->plotArea(), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    }
    if (hasFocus() && !m_inPicture) {
        painter->setPen(QPen(tokens.accent, 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(viewport()->rect().adjusted(1, 1, -1, -1));
    }
    painter->restore();
}

} // namespace gripscope
