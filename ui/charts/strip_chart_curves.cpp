// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_chart.h"

#include <QColor>
#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double tallColumn = 6;       ///< pixels: well over the width of a line
constexpr std::size_t fewestTall = 4;  ///< side by side; fewer are an edge or a peak, whose line is seen
constexpr double farthestColumn = 1.5; ///< pixels to the next one: further apart there is room for a line

/// One column of pixels: its ends in the order in which a line goes through them.
struct StripColumn {
    QPointF first, last;
    QPointF mean;
    [[nodiscard]] double top() const { return std::min(first.y(), last.y()); }
    [[nodiscard]] double height() const { return std::abs(last.y() - first.y()); }
};

std::vector<StripColumn> columnsOf(const LiveHistory::Stretch& stretch, const StripPlace& place)
{
    std::vector<StripColumn> columns;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
        StripColumn column;
        column.first = column.last = place(stretch[i]);
        if (i + 1 < stretch.size() && stretch[i + 1].x == stretch[i].x)
            column.last = place(stretch[++i]);
        column.mean = std::isfinite(stretch[i].mean) ? place({stretch[i].x, stretch[i].mean})
                                                     : (column.first + column.last) / 2;
        columns.push_back(column);
    }
    return columns;
}

/// How many tall columns stand side by side from here on.
std::size_t tallFrom(const std::vector<StripColumn>& columns, std::size_t from)
{
    std::size_t end = from;
    while (end < columns.size() && columns[end].height() > tallColumn &&
           (end == from || columns[end].first.x() - columns[end - 1].first.x() < farthestColumn))
        ++end;
    return end - from;
}

void addEnvelope(StripCurve& curve, const std::vector<StripColumn>& columns, std::size_t from,
                 std::size_t count)
{
    for (std::size_t i = from; i < from + count; ++i) {
        const double x = columns[i].first.x();
        const double left = i > from ? (columns[i - 1].first.x() + x) / 2 : x;
        const double right = i + 1 < from + count ? (x + columns[i + 1].first.x()) / 2 : x;
        curve.envelope << QRectF(left, columns[i].top(), right - left, columns[i].height());
        curve.line << columns[i].mean;
    }
}

} // namespace

std::vector<StripCurve> stripCurves(const std::vector<LiveHistory::Stretch>& stretches,
                                    const StripPlace& place)
{
    std::vector<StripCurve> curves;
    for (const LiveHistory::Stretch& stretch : stretches) {
        const std::vector<StripColumn> columns = columnsOf(stretch, place);
        StripCurve& curve = curves.emplace_back();
        for (std::size_t i = 0; i < columns.size();) {
            if (const std::size_t tall = tallFrom(columns, i); tall >= fewestTall) {
                addEnvelope(curve, columns, i, tall);
                i += tall;
                continue;
            }
            curve.line << columns[i].first;
            if (columns[i].height() > 0)
                curve.line << columns[i].last;
            ++i;
        }
    }
    return curves;
}

void paintEnvelopes(QPainter& painter, const std::vector<StripCurve>& curves, const QColor& color)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    for (const StripCurve& curve : curves)
        painter.drawRects(curve.envelope);
}

void paintCommanded(QPainter& painter, const std::vector<StripCurve>& curves, const QColor& color,
                    double thick)
{
    QList<QRectF> bars;
    for (const StripCurve& curve : curves) {
        for (qsizetype i = 0; i < curve.line.size(); ++i) {
            const QPointF here = curve.line[i];
            const QPointF next = i + 1 < curve.line.size() ? curve.line[i + 1] : here;
            const double low = std::min(here.y(), next.y());
            bars << QRectF(here.x() - thick / 2, here.y() - thick / 2, next.x() - here.x() + thick, thick)
                 << QRectF(next.x() - thick / 2, low - thick / 2, thick,
                           std::abs(next.y() - here.y()) + thick);
        }
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRects(bars);
}

void paintMeasured(QPainter& painter, const std::vector<StripCurve>& curves, const QColor& color,
                   double thick)
{
    // One wide polyline over dense data would take Qt most of a second: it unites the outline of all its
    // pieces. Tall pieces are upright bars, the others single lines; both are drawn in a few milliseconds.
    QList<QRectF> bars;
    QList<QLineF> lines;
    for (const StripCurve& curve : curves) {
        for (qsizetype i = 0; i < curve.line.size(); ++i) {
            const QPointF here = curve.line[i];
            const QPointF from = curve.line[std::max<qsizetype>(0, i - 1)];
            if (std::abs(here.x() - from.x()) < 1.5 && std::abs(here.y() - from.y()) > 4)
                bars << QRectF(here.x() - thick / 2, std::min(here.y(), from.y()), thick,
                               std::abs(here.y() - from.y()));
            else
                lines << QLineF(from, here);
        }
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRects(bars);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color, thick, Qt::SolidLine, Qt::SquareCap));
    painter.drawLines(lines);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

} // namespace gripscope
