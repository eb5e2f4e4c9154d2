// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/repeated_measurement.h"

#include <tl/expected.hpp>

namespace gripscope {

/// m, b and k of a series of squeezes, or in words why there are none: what made the first invalid squeeze
/// invalid, or that no numbers came out. Suspect squeezes are used: that a calibration or a check is overdue
/// must not keep anybody from making it good.
[[nodiscard]] tl::expected<RepeatedMeasurement, QString>
measuredTogether(std::span<const Identification> squeezes);

} // namespace gripscope
