// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/periodic.h"

namespace gripscope {

/// Fills `simulated`, `residual`, `fit`, `nuisance` and the residuals' sum of squares of an estimate with
/// known m, b, k: the exact response to the whole force, its start (x0, v0) and offset by linear least
/// squares on the positions that were measured. Left empty when the numbers leave their range.
void fitPeriodicResponse(const std::vector<double>& force, const std::vector<double>& position,
                         const PeriodicOptions& options, Estimate& estimate);

} // namespace gripscope
