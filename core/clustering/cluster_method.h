// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/clustering/cluster_advice.h"
#include "core/clustering/cluster_agreement.h"
#include "core/clustering/feature_scaling.h"
#include "core/clustering/gaussian_mixture.h"
#include "core/clustering/kmeans.h"
#include "core/clustering/self_organizing_map.h"

#include <Eigen/Core>
#include <QJsonObject>
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

/// The document of `gripscope-cli cluster --json`: method, labels, centroids, inertia, iterations,
/// adjusted_rand_index and confusion (null without truth), converged, scaling, seed; `mixture` (weights,
/// covariances in the scaled space, log_likelihood, bic, free_parameters) or `map` (rows, columns,
/// quantization_error, topographic_error, and by row and column hits, group, u_matrix and component_planes,
/// these in the table's own units) after the method; `advice` when it was asked for.
[[nodiscard]] QJsonObject clusterJson(const ClusterOutcome& outcome, const QStringList& features,
                                      const std::optional<ClusterAgreement>& agreement = {},
                                      const std::optional<ClusterAdvice>& advice = {});

} // namespace gripscope
