// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_curve.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace gripscope {

void paintMeasured(QPainter& painter, const std::vector<LiveHistory::Stretch>& stretches,
                   const StripPlace& place, const QColor& color, double thick)
{
    // One wide polyline over dense data would take Qt most of a second: it unites the outline of all its
    // pieces. Tall pieces are upright bars, the others single lines; both are drawn in a few milliseconds.
    QList<QRectF> bars;
    QList<QLineF> lines;
    for (const LiveHistory::Stretch& stretch : stretches) {
        QPointF before;
        for (std::size_t i = 0; i < stretch.size(); ++i) {
            const QPointF here = place(stretch[i]);
            const QPointF from = i == 0 ? here : before;
            if (std::abs(here.x() - from.x()) < 1.5 && std::abs(here.y() - from.y()) > 4)
                bars << QRectF(here.x() - thick / 2, std::min(here.y(), from.y()), thick,
                               std::abs(here.y() - from.y()));
            else
                lines << QLineF(from, here);
            before = here;
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

void paintCommanded(QPainter& painter, const std::vector<LiveHistory::Stretch>& stretches,
                    const StripPlace& place, const QColor& color, double thick)
{
    QList<QRectF> bars;
    for (const LiveHistory::Stretch& stretch : stretches) {
        for (std::size_t i = 0; i < stretch.size(); ++i) {
            const QPointF here = place(stretch[i]);
            const QPointF next = i + 1 < stretch.size() ? place(stretch[i + 1]) : here;
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

} // namespace gripscope
