// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace gripscope {

/// What the force channel of a gripper that can only push says about being in contact.
struct ContactForce {
    double sign = 1;      ///< of a pushing force in this record
    double threshold = 0; ///< above it (sign taken out) the gripper pushes
    bool oneSided = false;
};

/// The threshold is 5 % of the largest force (its 99 % quantile) or six standard deviations of its noise, the
/// larger of the two. The record is one-sided when no more than one sample in a hundred lies below minus the
/// threshold: a force that pulls belongs to an object that is held from both sides.
[[nodiscard]] ContactForce contactForce(std::span<const double> force);

} // namespace gripscope
