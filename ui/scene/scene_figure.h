// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_camera.h"
#include "ui/scene/scene_content.h"

#include <QPolygonF>
#include <QSizeF>

class QPainter;

namespace gripscope {

/// Writes tick numbers and titles along the three edges of the cube that lie outside of its picture. Numbers
/// that would overlap are left out; an axis seen end-on has none.
void paintSceneAxes(QPainter& painter, const SceneContent& content, const SceneCamera& camera, QSizeF size);

/// On which side (-1 or 1) of each axis the wall away from the camera is.
[[nodiscard]] Eigen::Vector3i farSides(const SceneCamera& camera);

/// The outline of an ellipsoid as a camera sees it, closed: the convex hull of the projections of points all
/// over its surface, which for a convex body is its silhouette, in perspective too. Too small by less than
/// 1 % of its radius.
[[nodiscard]] QPolygonF silhouette(const SceneContent& content, const Ellipsoid& ellipsoid,
                                   const SceneProjection& projection);

/// The space as lines and signs, for pictures without pixels: the walls behind, ellipsoids by their outlines,
/// points by their types' signs, what is far first; places are those that the rendered scene shows for this
/// camera. Nothing hides the parts of an ellipsoid that run through another one.
void paintSceneFigure(QPainter& painter, const SceneContent& content, const SceneCamera& camera, QSizeF size);

} // namespace gripscope
