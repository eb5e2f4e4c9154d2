// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>

namespace gripscope {

enum class SceneDirection { AlongMass, AlongDamping, AlongStiffness, Isometric };

/// From where the unit cube is seen; angles in degrees, k points up.
struct SceneCamera {
    double azimuth = -55;  ///< about the k axis, from the m axis towards the b axis
    double elevation = 22; ///< -90 to 90
    double zoom = 1;
    QPointF pan; ///< shift of the picture, in shares of its half height, x right, y down
    bool orthographic = false;

    void turn(double azimuthDegrees, double elevationDegrees);
    void zoomBy(double factor);
    /// Looks along one axis (the picture then is a pair plot of the other two), or at the whole cube.
    void lookAlong(SceneDirection direction);

    friend bool operator==(const SceneCamera&, const SceneCamera&) = default;
};

/// The camera for a picture of one size: where each point of the cube falls. The renderer and everything that
/// is painted or picked over its picture use this one mapping.
struct SceneProjection {
    SceneProjection(const SceneCamera& camera, QSizeF size);

    static constexpr double viewDistance = 5.2;    ///< from the middle of the cube, whose side is 1
    static constexpr double viewAngleDegrees = 20; ///< shows the whole cube and its labels at zoom 1

    Eigen::Vector3d right, up, forward, position;
    double halfHeight = 1; ///< of the picture, at the middle of the cube
    bool orthographic = false;
    QSizeF size;
    QPointF pan;

    struct Place {
        QPointF at;
        double depth = 0; ///< distance along the line of sight
    };
    [[nodiscard]] Place place(const Eigen::Vector3d& cubePoint) const;
    [[nodiscard]] QPointF at(const Eigen::Vector3d& cubePoint) const { return place(cubePoint).at; }
    /// Picture units (pixels) a unit of the cube, at its middle.
    [[nodiscard]] double pixelsPerUnit() const { return size.height() / (2 * halfHeight); }
};

} // namespace gripscope
