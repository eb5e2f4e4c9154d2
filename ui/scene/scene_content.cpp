// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_content.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

struct Bounds {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL);
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-HUGE_VAL);

    void include(const Eigen::Vector3d& at)
    {
        if (!at.allFinite())
            return;
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
    }
    void include(const Ellipsoid& ellipsoid)
    {
        const Eigen::Vector3d half = halfExtent(ellipsoid);
        include(ellipsoid.centre - half);
        include(ellipsoid.centre + half);
    }
};

/// The matrix S with x' S^-1 x = 1 on the ellipsoid (about its centre).
Eigen::Matrix3d spread(const Ellipsoid& ellipsoid)
{
    const Eigen::Matrix3d stretched = ellipsoid.axes * ellipsoid.radii.asDiagonal();
    return stretched * stretched.transpose();
}

} // namespace

Eigen::Vector3d halfExtent(const Ellipsoid& ellipsoid)
{
    return spread(ellipsoid).diagonal().cwiseMax(0).cwiseSqrt();
}

Eigen::Matrix<double, 3, 2> contentBounds(const SceneContent& content)
{
    Bounds bounds;
    for (const ScenePoint& point : content.points)
        bounds.include(point.at);
    for (const SceneEllipsoid& ellipsoid : content.ellipsoids)
        bounds.include(ellipsoid.shape);
    for (const SceneCentroid& centroid : content.centroids)
        for (const Eigen::Vector3d& at : centroid.trail)
            bounds.include(at);
    if (content.net)
        for (const Eigen::Vector3d& at : content.net->nodes)
            bounds.include(at);
    if (content.highlight) {
        bounds.include(content.highlight->point.at);
        if (content.highlight->ellipsoid)
            bounds.include(*content.highlight->ellipsoid);
    }
    Eigen::Matrix<double, 3, 2> result;
    if (bounds.low.allFinite() && bounds.high.allFinite())
        result << bounds.low, bounds.high;
    else
        result << Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones();
    return result;
}

std::vector<std::vector<Eigen::Vector3d>> ellipsoidRings(const Ellipsoid& ellipsoid, int segments)
{
    std::vector<std::vector<Eigen::Vector3d>> rings;
    for (int across = 0; across < 3; ++across) {
        const Eigen::Vector3d one = ellipsoid.axes.col((across + 1) % 3) * ellipsoid.radii[(across + 1) % 3];
        const Eigen::Vector3d two = ellipsoid.axes.col((across + 2) % 3) * ellipsoid.radii[(across + 2) % 3];
        std::vector<Eigen::Vector3d> ring;
        ring.reserve(std::size_t(segments) + 1);
        for (int i = 0; i <= segments; ++i) {
            const double angle = 2 * std::numbers::pi * i / segments;
            ring.emplace_back(ellipsoid.centre + std::cos(angle) * one + std::sin(angle) * two);
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

Eigen::Vector3d cubePosition(const SceneContent& content, const Eigen::Vector3d& value)
{
    Eigen::Vector3d position;
    for (int axis = 0; axis < 3; ++axis)
        position[axis] = content.axes[std::size_t(axis)].unitPosition(value[axis]) - 0.5;
    return position;
}

Eigen::Matrix2Xd ellipsoidOutline(const Ellipsoid& ellipsoid, int horizontal, int vertical, int count)
{
    // The shadow of x' S^-1 x = 1 on two axes is the ellipse of the matching 2 x 2 block of S. The axes
    // differ by orders of magnitude, so the block is brought to a unit diagonal before it is factored.
    const Eigen::Matrix3d s = spread(ellipsoid);
    const Eigen::Vector2d scale(std::sqrt(std::max(0.0, s(horizontal, horizontal))),
                                std::sqrt(std::max(0.0, s(vertical, vertical))));
    const double product = scale.x() * scale.y();
    const double correlation = product > 0 ? std::clamp(s(horizontal, vertical) / product, -1.0, 1.0) : 0.0;
    Eigen::Matrix2d factor;
    factor << 1, 0, correlation, std::sqrt(1 - correlation * correlation);
    const Eigen::Vector2d centre(ellipsoid.centre[horizontal], ellipsoid.centre[vertical]);
    Eigen::Matrix2Xd outline(2, count);
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        const Eigen::Vector2d unit(std::cos(angle), std::sin(angle));
        outline.col(i) = centre + scale.cwiseProduct(factor * unit);
    }
    return outline;
}

} // namespace gripscope
