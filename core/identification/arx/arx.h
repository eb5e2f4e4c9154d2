// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <Eigen/Core>

#include <optional>
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

/// m, b, k of y[t] + a1 y[t-1] + a2 y[t-2] = b1 u[t-1] by central differences of m x'' + b x' + k x = F:
///     m = T^2 (1 + a2) / (2 b1),   b = T (1 - a2) / b1,   k = (1 + a1 + a2) / b1.
/// Nothing unless b1 > 0, |a2| < 1 and 1 + a1 + a2 > 0.
[[nodiscard]] std::optional<MassDampingStiffness> centralDifferenceMapping(double a1, double a2, double b1,
                                                                           double sampleTime_s);
/// d (m, b, k) / d (a1, a2, b1).
[[nodiscard]] Eigen::Matrix3d centralDifferenceJacobian(double a1, double a2, double b1, double sampleTime_s);

/// m, b, k from the poles and the static gain, exact for a sampled second-order system; numeratorSum = b1 +
/// b2 (...).
///     s = -ln a2 / 2T,  c = -a1 / (2 sqrt a2),  wn^2 = s^2 + (acos c / T)^2  or  s^2 - (acosh c / T)^2,
///     k = (1 + a1 + a2) / numeratorSum,  m = k / wn^2,  b = 2 s m.
/// Nothing unless 0 < a2 < 1, c > -1, both poles are stable, and all three come out positive.
[[nodiscard]] std::optional<MassDampingStiffness> poleMapping(double a1, double a2, double numeratorSum,
                                                              double sampleTime_s);
/// d (m, b, k) / d (a1, a2, numeratorSum) where poleMapping() gives something.
[[nodiscard]] Eigen::Matrix3d poleJacobian(double a1, double a2, double numeratorSum, double sampleTime_s);

} // namespace gripscope
