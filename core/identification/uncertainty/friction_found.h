// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/measuring_chain.h"

#include <optional>

namespace gripscope {

/// Friction and its standard deviation, were it free to be below zero.
struct FrictionFound {
    double value = 0, deviation = 0;
};

/// What the record holds of friction and what is known of the gripper's together; the record alone where it
/// refutes that.
[[nodiscard]] FrictionFound together(const FrictionFound& found, const std::optional<GripperFriction>& known);

/// E f^2 of a normal quantity that is not below zero.
[[nodiscard]] double secondMoment(const FrictionFound& f);

} // namespace gripscope
