// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/kmeans.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// How much tighter a table is grouped than one without groups,
///     Gap(K) = mean over the references of ln W*(K), less ln W(K),
/// W the inertia of K-means; `error` is the deviation of ln W* times sqrt(1 + 1/references). References are
/// spread evenly over the box that holds the items, its sides along their principal axes.
/// Source: Tibshirani, Walther and Hastie, Estimating the number of clusters via the gap statistic (2001).
struct GapStatistic {
    double value = 0, error = 0;
};

struct GapOptions {
    int references = 20;
    int restarts = 3; ///< of K-means on each reference
    std::uint64_t seed = 1;
    std::shared_ptr<WorkWatch> watch; ///< told the references done, from `shareBefore` on; may stop it
    double shareBefore = 0;
};

/// `inertias`: of K-means on `items` with 1, 2, 3, ... clusters. Nothing where an inertia is 0, nor anywhere
/// once it was stopped.
[[nodiscard]] std::vector<std::optional<GapStatistic>> gapStatistics(const Eigen::MatrixXd& items,
                                                                     const std::vector<double>& inertias,
                                                                     const GapOptions& options = {});

/// The smallest K (from 1) whose gap is within one error of the first local maximum; nothing when the gap
/// still rises at the end. (The paper's own rule, Gap(K) >= Gap(K + 1) - error(K + 1), stops at 1 where
/// groups lie in groups.) Source: Maechler and others, package cluster of R, maxSE().
[[nodiscard]] std::optional<int> clustersByGap(const std::vector<std::optional<GapStatistic>>& gaps);

} // namespace gripscope
