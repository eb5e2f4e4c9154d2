// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/recognition/feature_scaling.h"
#include "core/recognition/gaussian_mixture.h"
#include "core/recognition/kmeans.h"
#include "core/recognition/self_organizing_map.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace gripscope {

/// The ways to group a table without labels.
enum class ClusterMethod { KMeans, SelfOrganizingMap, GaussianMixture };
/// "kmeans", "som", "gmm".
[[nodiscard]] QString toString(ClusterMethod method);
[[nodiscard]] std::optional<ClusterMethod> clusterMethodFromString(const QString& text);

struct ClusterRequest {
    ClusterMethod method = ClusterMethod::KMeans;
    FeatureScaling scaling = FeatureScaling::ZScore;
    MixtureCovariance covariance = MixtureCovariance::Full; ///< of the Gaussian mixture
    int clusters = 4;
    int restarts = 10;
    int candidates = 3; ///< tried for each new centre of K-means; 1: plain k-means++
    std::uint64_t seed = 1;
    bool recordSteps = true;
    std::shared_ptr<WorkWatch> watch; ///< may stop it: Cancelled
};

/// What every method finds, and beside it the method's own result, in the scaled space.
struct ClusterOutcome {
    ClusterRequest request;
    FeatureTransform transform;
    bool converged = false;
    int iterations = 0;
    std::vector<int> labels;   ///< from 0, numbered by first appearance
    Eigen::MatrixXd centroids; ///< in the table's own units; component means of a mixture
    double inertia = 0;        ///< sum of squared distances from them in the scaled space
    std::variant<KMeansResult, SelfOrganizingMapResult, GaussianMixtureResult> details;
};

/// Groups the rows of `table` (columns: features). Errors: those of the scaling and of the method; BadInput
/// when there are fewer rows than clusters.
[[nodiscard]] Expected<ClusterOutcome> groupRows(const Eigen::MatrixXd& table, const ClusterRequest& request);

} // namespace gripscope
