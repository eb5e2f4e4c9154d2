// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/periodic.h"
#include "core/identification/periodic_search.h"

namespace gripscope {

/// p-value of a cost V of so many lines: V is compared with a gamma distribution of its mean, lines - 3/2,
/// and its variance, sum of v/(v - 2) over lines (F ratios) and lines^2 over all measured degrees of freedom,
/// since neighbouring lines share bins.
[[nodiscard]] double periodicCostP(const PeriodicProblem& problem, double cost);

/// Ratios, noise levels and distortion, forces and positions in the problem's units times these scales.
[[nodiscard]] PeriodicDiagnostics periodicDiagnostics(const PeriodicProblem& problem,
                                                      const PeriodicSearch& search, double forceScale,
                                                      double positionScale, double sampleTime_s);

} // namespace gripscope
