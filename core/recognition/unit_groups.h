// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace gripscope {

/// Points that each stand for some items, merged two at a time until `groups` are left, always the two whose
/// merging raises the inertia least:
///     n_a n_b / (n_a + n_b) |mean_a - mean_b|^2
/// (of equals the first pair). With points that hold one item each this is Ward's clustering of the items.
/// `points`: rows, finite, their squares too; `items`: how many each stands for, above 0. Returns the group
/// of each point, numbered from 0 in order of appearance; fewer groups when there are fewer points. Takes
/// time in the square of the points, seldom more. Source: Ward, Hierarchical grouping to optimize an
/// objective function (1963).
[[nodiscard]] std::vector<int> wardGroups(const Eigen::MatrixXd& points, const Eigen::VectorXd& items,
                                          int groups);

} // namespace gripscope
