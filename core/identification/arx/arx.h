// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <vector>

namespace gripscope {

struct ArxOptions {
    Estimator estimator = Estimator::Arx; ///< Arx, ArxMeanForce or Arx221
    double sampleTime_s = 0;
    double lag_s = 0;       ///< shifted out to the nearest whole sample
    bool freeOffset = true; ///< a constant column
};

/// Least squares of y[t] + a1 y[t-1] + a2 y[t-2] = b1 u[t-1] (+ b2 u[t-2]) (+ constant) + e[t] over t
/// = 2..N-1, by QR.
///   Arx: one numerator term, m, b, k by the central-difference mapping (the paper's way);
///   ArxMeanForce: the same on the mean of successive forces, (u[t] + u[t-1]) / 2;
///   Arx221: two numerator terms, m, b, k by the pole mapping, exact for a held force.
/// The covariance of m, b, k follows from that of the coefficients by the derivative of the mapping. Noise on
/// the position biases all three heavily: it stands in the regressors too, whatever the fit.
///
/// Prediction: rows t = 2..N-1 with their own mean. Simulation: free run from the measured y[0], y[1], same
/// rows; not defined when an unstable model leaves the range of numbers. Statuses: Converged;
/// NoPhysicalMapping (coefficients and fits, no parameters); NotIdentifiable (columns dependent);
/// TooFewSamples. Numbers must be finite.
[[nodiscard]] Estimate estimateArx(const std::vector<double>& force, const std::vector<double>& position,
                                   const ArxOptions& options);

/// The least squares alone, without fits, tests and covariance; nothing where estimateArx() has no
/// coefficients.
[[nodiscard]] std::optional<ArxCoefficients> arxCoefficients(const std::vector<double>& force,
                                                             const std::vector<double>& position,
                                                             const ArxOptions& options);

} // namespace gripscope
