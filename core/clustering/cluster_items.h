// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// Items one after the other in memory, features side by side.
using ItemRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What every way of grouping needs of a table (rows: items, columns: features): finite numbers whose squares
/// can be added. BadInput otherwise.
[[nodiscard]] std::optional<Error> clusterItemsProblem(const Eigen::MatrixXd& items);

/// What a grouping fails with that was stopped.
[[nodiscard]] Error clusteringCancelled();

/// Usage when a count that must be at least 1 is not.
[[nodiscard]] std::optional<Error> countProblem(const QString& name, int value);

/// The power of two that brings the widest column of the table to a width of 1 to 2, so that squares neither
/// vanish nor overflow; 1 where no column has any width. Multiplying by it changes no digit.
[[nodiscard]] double powerOfTwoScale(const Eigen::MatrixXd& items);

/// How far from items that are all in one place their computed mean may be.
[[nodiscard]] double roundingOfMeans(const ItemRows& items);

/// New numbers for the clusters, by first appearance in the table, so that they do not depend on the start;
/// those without items come last.
[[nodiscard]] std::vector<int> numbersByAppearance(const std::vector<int>& labels, int clusters);

/// Sum of |x_i - centroid of its cluster|^2, in the space of the items.
[[nodiscard]] double inertiaOf(const Eigen::MatrixXd& items, const std::vector<int>& labels,
                               const Eigen::MatrixXd& centroids);

/// Rows of `items` in ascending order: all of them, or `most` drawn without replacement by the seed.
[[nodiscard]] Eigen::MatrixXd sampleOfItems(const Eigen::MatrixXd& items, Eigen::Index most,
                                            std::uint64_t seed);

/// 53 random bits as a number in [0, 1): std::uniform_real_distribution differs between standard libraries.
template <typename Generator>
[[nodiscard]] double uniformNumber(Generator& random)
{
    return double(random() >> 11) * 0x1p-53;
}

} // namespace gripscope
