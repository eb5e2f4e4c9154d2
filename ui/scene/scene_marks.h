// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_content.h"
#include "ui/theme/theme.h"

#include <QColor>
#include <QPointF>

#include <functional>
#include <vector>

class QPainter;

namespace gripscope {

[[nodiscard]] constexpr int typeShape(int type)
{
    return Theme::typeShape(type);
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
/// Where a value of m, b and k is on the screen.
using ScenePlace = std::function<QPointF(const Eigen::Vector3d&)>;

/// A thin line of the picked squeeze's own error.
void drawOwnError(QPainter& painter, const std::vector<Eigen::Vector3d>& line, const ScenePlace& place);
/// A map: lines between neighbours, a dot a unit.
void drawNet(QPainter& painter, const SceneNet& net, const ScenePlace& place);
/// A cluster centre where the trail ends, and the way it came.
void drawCentroid(QPainter& painter, const SceneCentroid& centroid, const ScenePlace& place);

} // namespace gripscope
