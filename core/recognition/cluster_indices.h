// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// Figures of merit of a grouping, computed from the items alone. `items`: rows, finite, their squares too;
/// `labels`: one an item, from 0. Clusters without items are not counted. Nothing where a figure does not
/// exist: fewer than two clusters, as many clusters as items, or clusters without any width.

/// Mean over the items of (b - a) / max(a, b): a is the mean distance to the others of the own cluster, b the
/// smallest mean distance to another cluster; 0 for an item alone in its cluster. From -1 to 1, high is good.
/// Takes time in the square of the items. Source: Rousseeuw, Silhouettes (1987).
[[nodiscard]] std::optional<double> silhouette(const Eigen::MatrixXd& items, const std::vector<int>& labels);

/// Between-cluster over within-cluster variance, (B / (K - 1)) / (W / (n - K)). High is good.
/// Source: Calinski and Harabasz, A dendrite method for cluster analysis (1974).
[[nodiscard]] std::optional<double> calinskiHarabasz(const Eigen::MatrixXd& items,
                                                     const std::vector<int>& labels);

/// Mean over the clusters of max_j (s_i + s_j) / |c_i - c_j|, s the mean distance from the cluster's mean c.
/// Low is good. Source: Davies and Bouldin, A cluster separation measure (1979).
[[nodiscard]] std::optional<double> daviesBouldin(const Eigen::MatrixXd& items,
                                                  const std::vector<int>& labels);

} // namespace gripscope
