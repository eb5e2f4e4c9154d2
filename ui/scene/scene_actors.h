// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// VTK stays behind scene_renderer.cpp and this file.
#include "ui/scene/scene_renderer.h"

#include <vtkActor.h>
#include <vtkGlyph3DMapper.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace gripscope {

/// The points of one colour and shape: the glyphs, and behind each a slightly larger one of which only the
/// inside is drawn, which leaves a thin outline that sets it off from the ground and from its neighbours.
struct PointActors {
    vtkSmartPointer<vtkActor> glyphs, outline;
    vtkSmartPointer<vtkGlyph3DMapper> glyphMapper, outlineMapper; ///< null for plain dots
};
[[nodiscard]] std::vector<PointActors> pointActors(const SceneContent& content, const SceneLook& look,
                                                   double ratio);

/// Translucent surface and thin wire.
struct EllipsoidActors {
    vtkSmartPointer<vtkActor> surface, wire;
};
[[nodiscard]] EllipsoidActors ellipsoidActors(const SceneContent& content, const Ellipsoid& ellipsoid,
                                              const QColor& color, double opacity, double lineWidth);

/// The rings of the errors of single squeezes, an actor a colour.
[[nodiscard]] std::vector<vtkSmartPointer<vtkActor>> errorActors(const SceneContent& content,
                                                                 double lineWidth);

/// The three far walls of the cube as seen by the camera, with a line a tick.
[[nodiscard]] std::vector<vtkSmartPointer<vtkActor>>
gridActors(const SceneContent& content, const SceneLook& look, const Eigen::Vector3i& farSide, double ratio);
} // namespace gripscope
