// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clustering/cluster_items.h"

#include <Eigen/Core>

namespace gripscope {

/// Items whose distances are measured at once; their numbers stay in the innermost cache.
inline constexpr Eigen::Index blockItems = 256;

/// The number of the centroid nearest to each item of a block: of equals the lowest; 0 where none is at a
/// finite distance. `columns`: `features` columns of blockItems numbers each; `centroids`: one a row;
/// `nearest`: blockItems numbers, as doubles, so that a comparison selects numbers and distances alike.
///     |x - c|^2 = ((x_1 - c_1)^2 + (x_2 - c_2)^2) + ... , added in this order without fused multiplication,
/// so that every processor finds the same to the last bit.
void findNearest(const double* columns, Eigen::Index features, const ItemRows& centroids, double* nearest);

namespace detail {
/// An item after the other, for any processor: what the other has to agree with.
void findNearestOneByOne(const double* columns, Eigen::Index features, const ItemRows& centroids,
                         double* nearest);
} // namespace detail

} // namespace gripscope
