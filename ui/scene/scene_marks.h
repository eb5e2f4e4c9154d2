// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>

#include <vector>

class QPainter;

namespace gripscope {

/// The shape of the n-th type. Its colour goes by n as well (Theme::typeColor()); the fifth's is close to the
/// first's, so from there on the shapes are shifted by one.
[[nodiscard]] constexpr int typeShape(int type)
{
    return (type + type / 4) % 4;
}

/// The flat sign of a type: disc, square, triangle, diamond, for sphere, cube, cone, octahedron. The same in
/// legends, pair plots and tables.
void drawTypeSign(QPainter& painter, QPointF at, double radius, int shape, const QColor& fill,
                  const QColor& outline);

/// The sign of a type with its colour and the outline that the theme asks for.
void drawTypeSign(QPainter& painter, QPointF at, double radius, int type);

/// The ring around the squeeze at hand: thick, with a gap to the point.
void drawHighlightRing(QPainter& painter, QPointF at);
/// The ring around a picked point: thin.
void drawPickRing(QPainter& painter, QPointF at);
/// A cluster centre where the trail ends, and the way it came.
void drawCentroid(QPainter& painter, const std::vector<QPointF>& trail, const QColor& color);

} // namespace gripscope
