// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/finding.h"
#include "core/clustering/kmeans.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>
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

/// What can say how many groups a table has. Only the last two can say that there is but one.
enum class ClusterCriterion { Silhouette, CalinskiHarabasz, DaviesBouldin, Gap, Bic };
/// "silhouette", "calinski_harabasz", "davies_bouldin", "gap", "bic".
[[nodiscard]] QString toString(ClusterCriterion criterion);

/// All figures for one number of clusters. K-means for all but the BIC, which is that of Gaussian mixtures.
struct ClusterFigures {
    int clusters = 1;
    double inertia = 0;
    std::optional<double> silhouette, calinskiHarabasz, daviesBouldin;
    std::optional<GapStatistic> gap;
    double bicTied = 0, bicFull = 0;
};

/// The number that one criterion is for; nothing when it cannot say.
struct ClusterVote {
    ClusterCriterion criterion = ClusterCriterion::Silhouette;
    std::optional<int> clusters;
};

struct ClusterAdviceOptions {
    int maxClusters = 8;
    int restarts = 10;             ///< of K-means; mixtures take 3
    Eigen::Index mostItems = 2000; ///< longer tables are judged by that many items, drawn by the seed
    std::uint64_t seed = 1;
    std::shared_ptr<WorkWatch> watch; ///< told how far it is; may stop it: Cancelled
};

struct ClusterAdvice {
    int clusters = 1;
    Finding reason; ///< a sentence for a person
    std::vector<ClusterFigures> figures;
    std::vector<ClusterVote> votes; ///< one a criterion
    Eigen::Index itemsUsed = 0;
};

/// How many groups `items` (rows: items, columns: features; scaled by the caller as for the grouping) seem to
/// have. Silhouette and Calinski-Harabasz are highest at their number, Davies-Bouldin and BIC lowest; the gap
/// has its own rule (clustersByGap()). One group is advised when all that can say so do; else the number with
/// most votes, of equals the silhouette's, else the smallest. Errors: Usage (options), BadInput (no items;
/// numbers that are not finite, or too large to be squared), Cancelled.
[[nodiscard]] Expected<ClusterAdvice> adviseClusters(const Eigen::MatrixXd& items,
                                                     const ClusterAdviceOptions& options = {});

} // namespace gripscope
