// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

namespace gripscope {

/// Differences of BIC below this decide nothing (Kass and Raftery 1995: "very strong").
inline constexpr double decisiveDelta = 10;

/// Whether the evidence is decisively against one estimate of a record beside another of the same samples, by
/// BIC under white noise: N ln(SSE / SSE of the other), less ln N for each unknown that it has fewer.
/// `positionStep`: of the position's counts, 0 for none; a mean square below that of rounding to them,
/// step^2 / 12, says no more than that, nor does one at the size of rounding errors.
[[nodiscard]] bool isDecisivelyWorse(const Estimate& estimate, const Estimate& other, double positionStep);

} // namespace gripscope
