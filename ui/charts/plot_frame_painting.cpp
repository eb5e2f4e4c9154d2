// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/axis_ticks.h"
#include "ui/charts/line_clipping.h"
#include "ui/charts/plot_frame.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QPainter>
#include <QScatterSeries>
#include <QValueAxis>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double numberOverhang = 13; ///< of a number beyond the plot's right edge: its margin is 14

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

void paintLine(QPainter& painter, const QLineSeries& series, const AxisMap& map, const QRectF& area)
{
    painter.setPen(series.pen());
    painter.setBrush(Qt::NoBrush);
    QPolygonF line;
    for (const QPointF& point : series.points())
        line << map(point);
    drawLineInside(painter, line, area);
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
    const QRect all(QPoint(), pictureSize());
    render(&painter, all, all);
    for (QAbstractSeries* one : series)
        one->setVisible(true);
    paintSeries(painter, *chart());
    if (ownAxis)
        setHorizontalTitle({});
    chart()->layout()->activate(); // before the screen is painted again
    m_inPicture = false;
}

QPointF PlotFrame::pixelOf(QPointF point) const
{
    const QRectF area = chart()->plotArea();
    const PlotRange across = horizontal(), up = vertical();
    return {area.left() + (point.x() - across.low) / across.span() * area.width(),
            area.bottom() - (point.y() - up.low) / up.span() * area.height()};
}

void PlotFrame::paintLogarithmicGrid(QPainter* painter) const
{
    const QRectF area = chart()->plotArea();
    painter->setPen(m_horizontal->gridLinePen());
    if (m_logarithmicHorizontal)
        for (const LogarithmicTick& tick :
             logarithmicTicks(m_horizontal->min(), m_horizontal->max(), horizontalSteps())) {
            const double x = pixelOf({tick.exponent, 0}).x();
            painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        }
    if (m_logarithmicVertical)
        for (const LogarithmicTick& tick :
             logarithmicTicks(m_vertical->min(), m_vertical->max(), verticalSteps())) {
            const double y = pixelOf({0, tick.exponent}).y();
            painter->drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        }
}

void PlotFrame::paintLogarithmicNumbers(QPainter* painter) const
{
    const QRectF area = chart()->plotArea();
    painter->setFont(Theme::font(metrics::fontSmall));
    painter->setPen(Theme::instance().tokens().secondText);
    if (m_logarithmicHorizontal && !m_horizontalTitle.isEmpty())
        for (const LogarithmicTick& tick :
             logarithmicTicks(m_horizontal->min(), m_horizontal->max(), horizontalSteps())) {
            const double width = QFontMetricsF(painter->font()).horizontalAdvance(tick.label) + 2;
            // Whole within the picture, also at its right edge.
            const double left =
                std::min(pixelOf({tick.exponent, 0}).x() - width / 2, area.right() + numberOverhang - width);
            painter->drawText(QRectF(left, area.bottom() + 4, width, 18), Qt::AlignCenter, tick.label);
        }
    if (m_logarithmicVertical)
        for (const LogarithmicTick& tick :
             logarithmicTicks(m_vertical->min(), m_vertical->max(), verticalSteps()))
            painter->drawText(QRectF(0, pixelOf({0, tick.exponent}).y() - 9, area.left() - 6, 18),
                              Qt::AlignRight | Qt::AlignVCenter, tick.label);
}

void PlotFrame::drawBackground(QPainter* painter, const QRectF& rect)
{
    QChartView::drawBackground(painter, rect);
    paintLogarithmicGrid(painter);
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
    title = elided(QFontMetricsF(strong), title, std::max(0.0, room.width() - findingWidth));
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

double PlotFrame::titleRoom(const QFontMetricsF& letters) const
{
    if (m_logarithmicHorizontal) {
        const auto ticks = logarithmicTicks(m_horizontal->min(), m_horizontal->max(), horizontalSteps());
        if (!ticks.empty())
            return pixelOf({ticks.front().exponent, 0}).x() -
                   letters.horizontalAdvance(ticks.front().label) / 2 - 4;
    }
    // The first number stands about the corner of the plot, half of it on either side.
    const QString first =
        QString::number(m_horizontal->min(), 'f', decimalsOf(std::abs(m_horizontal->tickInterval())));
    return chart()->plotArea().left() - letters.horizontalAdvance(first) / 2 - 4;
}

QString PlotFrame::horizontalTitleIn(double room, const QFontMetricsF& letters) const
{
    const qsizetype unit = m_horizontalTitle.lastIndexOf(u'(');
    return letters.horizontalAdvance(m_horizontalTitle) <= room || unit < 0 ? m_horizontalTitle
                                                                            : m_horizontalTitle.mid(unit);
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
        painter->drawText(QRectF(0, area.bottom() + 4, titleRoom(small), 18),
                          Qt::AlignRight | Qt::AlignVCenter, horizontalTitleIn(titleRoom(small), small));
    }
    if (m_band)
        entry(m_bandName, [&](QPointF at) {
            painter->fillRect(QRectF(at.x(), at.y() - 4, 18, 8),
                              Theme::mix(tokens.surface, tokens.accent, 0.25));
        });
    for (auto i = m_legend.rbegin(); i != m_legend.rend(); ++i)
        entry(i->width > 0 ? i->name : i->name.mid(1).trimmed(), [&](QPointF at) {
            if (i->width == 0) { // of points: the sign that the name begins with, in their colour
                painter->setPen(i->color);
                return painter->drawText(QRectF(at.x(), at.y() - 9, 18, 18), Qt::AlignCenter,
                                         i->name.left(1));
            }
            painter->setPen(QPen(i->color, i->width, Qt::SolidLine, Qt::FlatCap));
            painter->drawLine(at, at + QPointF(18, 0));
        });
}

void PlotFrame::drawForeground(QPainter* painter, const QRectF&)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter->save();
    paintHeader(painter);
    paintLogarithmicNumbers(painter);
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
