// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_camera.h"
#include "ui/scene/scene_content.h"

class QPainter;

namespace gripscope {

/// Writes tick numbers and titles along the three edges of the cube that lie outside of its picture. Numbers
/// that would overlap are left out; an axis seen end-on has none.
void paintSceneAxes(QPainter& painter, const SceneContent& content, const SceneCamera& camera, QSizeF size);

/// On which side (-1 or 1) of each axis the wall away from the camera is.
[[nodiscard]] Eigen::Vector3i farSides(const SceneCamera& camera);

} // namespace gripscope
