// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/recognition/cluster_gap.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

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
    QString reason; ///< a sentence for a person
    std::vector<ClusterFigures> figures;
    std::vector<ClusterVote> votes; ///< one a criterion
    Eigen::Index itemsUsed = 0;
};

/// How many groups `items` (rows: items, columns: features; scaled by the caller as for the grouping) seem to
/// have. Silhouette and Calinski-Harabasz are highest at their number, Davies-Bouldin and BIC lowest; the gap
/// has its own rule (cluster_gap.h). One group is advised when all that can say so do; else the number with
/// most votes, of equals the silhouette's, else the smallest. Errors: Usage (options), BadInput (no items;
/// numbers that are not finite, or too large to be squared), Cancelled.
[[nodiscard]] Expected<ClusterAdvice> adviseClusters(const Eigen::MatrixXd& items,
                                                     const ClusterAdviceOptions& options = {});

} // namespace gripscope
