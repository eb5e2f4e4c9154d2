// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/map_training.h"
#include "core/recognition/principal_axes.h"
#include "core/recognition/self_organizing_map.h"

#include <Eigen/Core>

#include <random>

namespace gripscope {

/// The grid that the options name or leave open: about 5 sqrt(items) units, but enough for the groups; sides
/// in the ratio of the two widest directions. Vesanto and Alhoniemi (2000).
[[nodiscard]] MapGrid chooseGrid(const SelfOrganizingMapOptions& options, Eigen::Index items,
                                 const PrincipalAxes& axes);

/// Weights on the plane of the two widest directions, two standard deviations either way, the longer side of
/// the grid along the wider one (Kohonen's linear start).
[[nodiscard]] Eigen::MatrixXd weightsOnPlane(const MapGrid& grid, const PrincipalAxes& axes);

/// Items drawn at random, with replacement.
[[nodiscard]] Eigen::MatrixXd weightsFromItems(const MapGrid& grid, const Eigen::MatrixXd& items,
                                               std::mt19937_64& random);

} // namespace gripscope
