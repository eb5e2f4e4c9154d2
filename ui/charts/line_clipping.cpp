// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/line_clipping.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace gripscope {

std::optional<QLineF> lineInside(const QLineF& line, const QRectF& area)
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

void drawLineInside(QPainter& painter, const QPolygonF& points, const QRectF& area)
{
    QPolygonF run;
    const auto flush = [&] {
        if (run.size() > 1)
            painter.drawPolyline(run);
        run.clear();
    };
    for (qsizetype i = 1; i < points.size(); ++i) {
        const std::optional<QLineF> part = lineInside({points[i - 1], points[i]}, area);
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

} // namespace gripscope
