// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/signal/measuring_chain.h"

#include <Eigen/Core>

#include <optional>

namespace gripscope {

/// m, b, k of the object alone with their covariance, in the channels' units.
struct CorrectedParameters {
    MassDampingStiffness parameters;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The empty gripper's own mass, damping and stiffness move in parallel with the object's, so that the forces
/// add: what is measured is (m, b, k) of both together, and the object's are the differences. The baseline
/// was measured on its own, so that the covariances add (JCGM 100, 5.1.2); its three errors count as
/// independent, since only their sizes are kept.
///
/// Nothing when a difference is not above zero (the object is not told from the empty gripper) or when a
/// number is not finite.
[[nodiscard]] std::optional<CorrectedParameters> withoutGripper(const MassDampingStiffness& measured,
                                                                const Eigen::Matrix3d& covariance,
                                                                const GripperBaseline& baseline);

} // namespace gripscope
