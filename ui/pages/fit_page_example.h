// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/signal/recording.h"

namespace gripscope {

/// A simulated squeeze of an object in SI (2 kHz, one second, PRBS of 20 +- 10 N, position noise of 5 um),
/// for pages that have to show something before there is a gripper. Its provenance says that it is simulated.
[[nodiscard]] Recording simulatedSqueeze(const MassDampingStiffness& object, std::uint64_t seed);

} // namespace gripscope
