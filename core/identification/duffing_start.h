// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/duffing_model.h"

#include <vector>

namespace gripscope {

/// Where the search for a cubic spring can begin, the candidate whose simulation fits best first; at most
/// three.
///  - Least squares on state-variable filters of some bandwidths (Young 1981), M f(y'') + B f(y') + c3 f(y^3)
///  +
///    c2 f(y^2) + c1 f(y) + c0 = f(F), c2 and c0 for a free offset, which is the static position without
///    force.
///  - From each of `others`, and from it with a part of its spring turned into a cubic one by harmonic
///    balance: a spring k that fits a motion of amplitude a is K + 3/4 K3 a^2 (Duffing 1918).
[[nodiscard]] std::vector<DuffingPoint> duffingStarts(const DuffingProblem& problem,
                                                      const std::vector<DuffingPoint>& others);

} // namespace gripscope
