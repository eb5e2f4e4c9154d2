// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gripscope {

/// The samples at which a gripper that can only push had left the object: an object can't be pulled, so that
/// while the command would pull, the force rests at zero and the gripper moves on its own. Such a run has
/// three samples at rest or more, and in it the position leaves the squeeze's range (99 % of the positions
/// under load) by as much again and six times its noise; one sample on either side goes with it. A free swing
/// in contact hardly ever goes that far, however weak the damping, so that runs which stay nearer are kept as
/// contact without force. Sorted; empty for a force that
/// also pulls. The channels are equally long and hold the squeeze only.
[[nodiscard]] std::vector<std::size_t> findContactLoss(std::span<const double> force,
                                                       std::span<const double> position);

} // namespace gripscope
