// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_agreement.h"
#include "core/recognition/feature_scaling.h"
#include "core/recognition/kmeans.h"
#include "core/recognition/type_model.h"

#include <Eigen/Core>
#include <QJsonObject>
#include <QStringList>

#include <vector>

namespace gripscope {

/// The paper's appendix: 10 squeezes of each of 4 cans. "Units as printed": the paper names none.
struct PaperAppendix {
    QStringList object;         ///< A..D, one a row
    Eigen::MatrixXd parameters; ///< 40 x 3: m, b, k
    std::vector<double> bestFitPercent;
};
[[nodiscard]] const PaperAppendix& paperAppendix();

/// Seconds in one of the paper's units of time that turn its cans into plausible ones in SI: m stays, b is
/// divided by it, k by its square (A: 0.0396 kg, 43.0 N s/m, 9,990 N/m; natural frequency 80 Hz).
inline constexpr double paperTimeUnit_s = 0.0032;
[[nodiscard]] std::vector<TypeSqueeze> paperSqueezesAsPrinted();
[[nodiscard]] std::vector<TypeSqueeze> paperSqueezesInSi();

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
