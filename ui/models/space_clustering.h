// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clustering/cluster_advice.h"
#include "core/clustering/cluster_agreement.h"
#include "core/clustering/cluster_method.h"
#include "ui/models/type_space.h"

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

class WorkWatch;

/// The squeezes of a space grouped without labels, with every iteration on the way, and how the groups agree
/// with the types. States are numbered from 0, the start, to states() - 1, the end.
struct SpaceClustering {
    ClusterOutcome outcome; ///< in the scaled space
    ClusterAgreement agreement;
    std::vector<std::vector<int>>
        table; ///< Table 1 of the paper, cluster numbers from 1; empty for types of more than 12 squeezes
    std::optional<double> randIndex; ///< adjusted; none where there is but one type

    [[nodiscard]] int states() const;
    /// The cluster of each squeeze. A map forms its groups at the end: those, in every state.
    [[nodiscard]] const std::vector<int>& labels(int state) const;
    /// Clusters x 3, in the units of the space; empty for a map.
    [[nodiscard]] Eigen::MatrixXd centres(int state) const;
    /// What holds 95 % of each component of a mixture, none where it cannot be drawn; empty for the others.
    [[nodiscard]] std::vector<std::optional<Ellipsoid>> ellipsoids(int state) const;
    /// What a person must know of the result: no rest found, clusters without squeezes. Often empty.
    [[nodiscard]] QString remark() const;
    /// What the method has reached by then: its inertia, log-likelihood or quantisation error, in words.
    [[nodiscard]] QString figure(int state) const;
    /// The weights of a map, units x 3, in the units of the space; empty for the others.
    [[nodiscard]] Eigen::MatrixXd weights(int state) const;
};

/// What is asked for, with the defaults of the page: as many clusters as types.
[[nodiscard]] ClusterRequest clusterRequest(const TypeSpace& space);

/// Runs `request`. Usage, in words for a person, when there are too few squeezes; otherwise what groupRows()
/// fails with.
[[nodiscard]] Expected<SpaceClustering> clusterTypeSpace(const TypeSpace& space,
                                                         const ClusterRequest& request);

/// How many clusters the squeezes seem to have in that scaling: 1 to 8 are looked at. `watch` may stop it
/// (Cancelled).
[[nodiscard]] Expected<ClusterAdvice> adviseTypeSpace(const TypeSpace& space, FeatureScaling scaling,
                                                      const std::shared_ptr<WorkWatch>& watch = {});

} // namespace gripscope
