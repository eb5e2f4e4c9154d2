// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <vector>

namespace gripscope {

/// How to find m, b, k and the cubic stiffness k3.
struct DuffingOptions : ContinuousTimeOptions {
    double startCubic = 0; ///< k3 that belongs to `start`
    int maxIterations = 100;
};

/// Minimises sum (y - x - offset)^2, x the motion of m x'' + b x' + k x + k3 x^3 = F (Duffing 1918) under the
/// force as it is held; x is measured from the offset. k3 > 0 stiffens, k3 < 0 softens; m, b, k > 0.
///
/// The linear spring is integrated exactly, the cubic one by a method of order 4 (DuffingStep), in steps
/// halved until the error of the integration moves no parameter by more than a hundredth of its standard
/// error (and positions by no more than 1e-9 of their size where there is no noise). Levenberg-Marquardt in
/// ln m, ln b, ln k, k3, x0, v0 and offset with the exact derivatives of the integrated motion, from
/// equation-error and linear output-error starts. Under white Gaussian position noise and known force this is
/// the maximum-likelihood estimate; `cubic->covariance` = s^2 (J'J)^-1 of (m, b, k, k3), s^2 = SSE / (N - p),
/// p counting these four and every free nuisance, and `covariance` is its part for (m, b, k).
///
/// All numbers must be finite, force and position equally long, the sample time positive. Statuses:
/// Converged; NotConverged with the last iterate; TooFewSamples when N <= p; NotIdentifiable with words when
/// the data does not determine the four. About 1 s for 10^5 samples.
///
/// Where samples were lost their forces are those that output error finds (completedRecord()), at first with
/// a linear spring, then in positions without what the cubic one adds; their rows are skipped, and the errors
/// grow as those of output error do.
[[nodiscard]] Estimate estimateDuffing(const std::vector<double>& force, const std::vector<double>& position,
                                       const DuffingOptions& options);

} // namespace gripscope
