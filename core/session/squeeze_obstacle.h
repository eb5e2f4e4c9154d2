// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <span>

namespace gripscope {

/// Why a series of squeezes cannot be used: what made the first invalid one invalid. Empty when none is.
/// Suspect ones are used: that a calibration or a check is overdue must not keep anybody from making it good.
[[nodiscard]] QString obstacleOf(std::span<const Identification> squeezes);

} // namespace gripscope
