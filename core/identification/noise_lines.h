// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/effect_regression.h"
#include "core/identification/uncertainty_budget.h"

#include <vector>

namespace gripscope {

/// The lines of an uncertainty budget (see uncertaintyBudget()) that come from the channels' noise: one from
/// the residuals; or, where the force channel's noise is known, one for each channel. Then the force's noise
/// F(t) moves the position by g * F, g the model's impulse response, and the estimate by
///     A' (g * F),   A' = (S'S)^-1 S',
/// S the sensitivities without the nuisances: covariance sd^2 (A' G)(A' G)', G the convolution with g; the
/// position's noise has what is left of the residuals' variance. Exact for white noise, to first order in the
/// noise. Residuals whose colour this does not explain keep their own noise model where that asks for more.
[[nodiscard]] std::vector<BudgetLine> noiseLines(const Estimate& estimate, const LinearizedRecord& record,
                                                 const OutputErrorOptions& options,
                                                 double forceNoiseDeviation);

} // namespace gripscope
