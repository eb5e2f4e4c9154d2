// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clustering/cluster_agreement.h"
#include "core/clustering/feature_scaling.h"
#include "core/clustering/kmeans.h"

#include <QJsonObject>

#include <cstdint>
#include <vector>

namespace gripscope {

/// K-means on the appendix in one scaling, with everything a table or a plot of it needs.
struct PaperClustering {
    FeatureScaling scaling = FeatureScaling::ZScore;
    KMeansResult result; ///< in the scaled space
    FeatureTransform transform;
    ClusterAgreement agreement;
    std::vector<std::vector<int>> table1;
};
[[nodiscard]] PaperClustering clusterPaperAppendix(FeatureScaling scaling, std::uint64_t seed = 1);

/// The document of `gripscope-cli reproduce-paper --json`.
[[nodiscard]] QJsonObject reproducePaper();

} // namespace gripscope
