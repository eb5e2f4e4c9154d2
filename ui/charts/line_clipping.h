// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPolygonF>
#include <QRectF>

#include <optional>

class QPainter;

namespace gripscope {

// What a plot paints ends at its edges by geometry: SVG files get no clip.

/// The part of a line inside of `area` (Liang and Barsky 1984).
[[nodiscard]] std::optional<QLineF> lineInside(const QLineF& line, const QRectF& area);
/// The line from point to point, as much of it as is inside of `area`.
void drawLineInside(QPainter& painter, const QPolygonF& points, const QRectF& area);

} // namespace gripscope
