// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clustering/cluster_items.h"

#include <Eigen/Core>

namespace gripscope {

/// Items whose distances are measured at once.
inline constexpr Eigen::Index blockItems = 64;

/// Gives each item of a block the number of the centroid nearest to it: of equals the lowest; 0 where none is
/// at a finite distance. How many labels changed. `columns`: `features` columns of blockItems numbers each;
/// `centroids`: one a row; `labels`: blockItems numbers.
///     |x - c|^2 = ((x_1 - c_1)^2 + (x_2 - c_2)^2) + ... , added in this order without fused multiplication,
/// so that every processor finds the same to the last bit.
int assignBlock(const double* columns, Eigen::Index features, const ItemRows& centroids, int* labels);

namespace detail {
/// An item after the other, for any processor: what the other has to agree with.
int assignOneByOne(const double* columns, Eigen::Index features, const ItemRows& centroids, int* labels);
} // namespace detail

} // namespace gripscope
