// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"
#include "ui/charts/axis_ticks.h"

#include <Eigen/Core>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace gripscope {

/// One squeeze in the space of m, b and k, in the units of the axes.
struct ScenePoint {
    QString id;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    int color = 0; ///< index into Theme::typeColor()
    int shape = 0; ///< sphere, cube, cone, octahedron
};

struct SceneEllipsoid {
    Ellipsoid shape;
    int color = 0;
};

/// The squeeze at hand: a ringed point with the ellipsoid of its own uncertainty.
struct SceneHighlight {
    ScenePoint point;
    std::optional<Ellipsoid> ellipsoid;
};

/// A cluster centre and where it came from; the last of `trail` is where it is.
struct SceneCentroid {
    std::vector<Eigen::Vector3d> trail;
    int color = 0;
};

/// A self-organizing map among the points: its units, and lines between neighbours on its grid.
struct SceneNet {
    std::vector<Eigen::Vector3d> nodes;
    std::vector<int> colors; ///< one a node
    std::vector<std::pair<int, int>> edges;
};

/// Above this many points they are drawn as plain dots. In software rendering a thousand glyphs cost as much
/// as 100,000 dots.
inline constexpr std::size_t mostGlyphs = 1000;

/// All that a view of the m-b-k space shows. A value: build it, hand it over, forget it.
struct SceneContent {
    std::array<AxisScale, 3> axes; ///< m, b, k
    std::vector<ScenePoint> points;
    std::vector<SceneEllipsoid> ellipsoids;
    std::vector<SceneEllipsoid> errors; ///< of single squeezes: wires only
    std::vector<SceneCentroid> centroids;
    std::optional<SceneNet> net;
    std::optional<SceneHighlight> highlight;
};

/// The smallest and the largest values along each axis of points, ellipsoids, trails, net and highlight
/// (columns: low, high). Without any of them: 0 to 1.
[[nodiscard]] Eigen::Matrix<double, 3, 2> contentBounds(const SceneContent& content);

/// Half the extent of an ellipsoid along each axis of the space.
[[nodiscard]] Eigen::Vector3d halfExtent(const Ellipsoid& ellipsoid);

/// Three ellipses about the centre, each through two of the axes, as closed lines of values.
[[nodiscard]] std::vector<std::vector<Eigen::Vector3d>> ellipsoidRings(const Ellipsoid& ellipsoid,
                                                                       int segments = 32);

/// Where a value lies in the cube of side 1 around the origin that the axes span.
[[nodiscard]] Eigen::Vector3d cubePosition(const SceneContent& content, const Eigen::Vector3d& value);

/// The outline of an ellipsoid seen along the third axis, as a 2 x count matrix of values of axes
/// `horizontal` and `vertical`: the shadow of the whole ellipsoid, not a cut through it.
[[nodiscard]] Eigen::Matrix2Xd ellipsoidOutline(const Ellipsoid& ellipsoid, int horizontal, int vertical,
                                                int count = 72);

} // namespace gripscope
