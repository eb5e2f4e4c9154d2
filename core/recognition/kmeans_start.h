// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <random>

namespace gripscope {

/// The first centres of K-means by greedy k-means++: the first is any item; each further one is, of
/// `candidates` items drawn with probability proportional to the squared distance from the nearest centre so
/// far, the one that lowers the sum of these distances most.
/// Source: Arthur and Vassilvitskii, k-means++: the advantages of careful seeding (2007), section 2.2 and
/// their code's greedy variant.
[[nodiscard]] Eigen::MatrixXd startingCentres(const Eigen::MatrixXd& items, int clusters, int candidates,
                                              std::mt19937_64& random);

} // namespace gripscope
