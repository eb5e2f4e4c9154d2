// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/result/determined_parameters.h"

#include <QString>

namespace gripscope {

/// "Mass m", "Friction Fc": for a row's head.
[[nodiscard]] QString parameterName(MotionParameter parameter);

/// "9.98 ± 0.05 kN/m", "at most 0.02 N", "at least 1.5 kN/m", in the units that the person reads.
[[nodiscard]] QString determinedText(const DeterminedParameter& one);

/// The friction, yielding and whatever else there is besides m, b and k, in one line: "Friction Fc 0.40 ±
/// 0.02 N · Relaxation time τ 51 ± 3 ms"; empty where there is nothing.
[[nodiscard]] QString furtherText(const std::vector<DeterminedParameter>& all);

} // namespace gripscope
