// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_advice.h"
#include "core/recognition/cluster_agreement.h"
#include "core/recognition/cluster_method.h"

#include <QJsonObject>

#include <optional>

namespace gripscope {

/// The document of `gripscope-cli cluster --json`: method, labels, centroids, inertia, iterations,
/// adjusted_rand_index and confusion (null without truth), converged, scaling, seed; `mixture` (weights,
/// covariances in the scaled space, log_likelihood, bic, free_parameters) or `map` (rows, columns,
/// quantization_error, topographic_error, and by row and column hits, group, u_matrix and component_planes,
/// these in the table's own units) after the method; `advice` when it was asked for.
[[nodiscard]] QJsonObject clusterJson(const ClusterOutcome& outcome, const QStringList& features,
                                      const std::optional<ClusterAgreement>& agreement = {},
                                      const std::optional<ClusterAdvice>& advice = {});

} // namespace gripscope
