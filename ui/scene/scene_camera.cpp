// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {
double radians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}
} // namespace

void SceneCamera::turn(double azimuthDegrees, double elevationDegrees)
{
    azimuth = std::remainder(azimuth + azimuthDegrees, 360.0);
    elevation = std::clamp(elevation + elevationDegrees, -90.0, 90.0);
}

void SceneCamera::zoomBy(double factor)
{
    zoom = std::clamp(zoom * factor, 0.25, 40.0);
}

void SceneCamera::lookAlong(SceneDirection direction)
{
    zoom = 1.5; // one face fills less of the picture than the cube on its corner
    pan = QPointF();
    switch (direction) {
    case SceneDirection::AlongMass: // damping to the right, stiffness up
        azimuth = 0;
        elevation = 0;
        return;
    case SceneDirection::AlongDamping: // mass to the right, stiffness up
        azimuth = -90;
        elevation = 0;
        return;
    case SceneDirection::AlongStiffness: // mass to the right, damping up
        azimuth = -90;
        elevation = 90;
        return;
    case SceneDirection::Isometric: {
        const bool keep = orthographic;
        *this = SceneCamera();
        orthographic = keep;
        return;
    }
    }
}

SceneProjection::SceneProjection(const SceneCamera& camera, QSizeF pictureSize)
    : orthographic(camera.orthographic), size(pictureSize), pan(camera.pan)
{
    const double azimuth = radians(camera.azimuth);
    const double elevation = radians(camera.elevation);
    forward = -Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                               std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    // From the angles, not from a cross product with "up", so that looking straight down is no special case.
    right = Eigen::Vector3d(-std::sin(azimuth), std::cos(azimuth), 0);
    up = Eigen::Vector3d(-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
                         std::cos(elevation));
    position = -viewDistance * forward;
    const double narrow = size.width() > 0 ? std::max(1.0, size.height() / size.width()) : 1.0;
    halfHeight = viewDistance * std::tan(radians(viewAngleDegrees / 2)) * narrow / camera.zoom;
}

SceneProjection::Place SceneProjection::place(const Eigen::Vector3d& cubePoint) const
{
    const Eigen::Vector3d seen = cubePoint - position;
    const double depth = seen.dot(forward);
    const double nearness = orthographic ? 1.0 : viewDistance / std::max(0.1, depth);
    const double half = size.height() / 2;
    const double scale = nearness * half / halfHeight;
    return {QPointF(size.width() / 2 + seen.dot(right) * scale + pan.x() * half,
                    half - seen.dot(up) * scale + pan.y() * half),
            depth};
}

} // namespace gripscope
