// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/signal/recording/recording.h"

#include <Eigen/Core>

#include <span>

namespace gripscope {

/// How the position is sampled and what must be found besides m, b and k.
struct SensitivityOptions {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::Zero;
    bool freeInitialState = true;
    bool freeOffset = true;
};

/// What a force tells about m, b and k of m x'' + b x' + k x = F, from rest at zero. Rows are samples.
struct ResponseSensitivities {
    Eigen::VectorXd position;
    Eigen::MatrixX3d parameters; ///< d x / d ln m, d ln b, d ln k
    Eigen::MatrixXd nuisances;   ///< orthonormal: all that x0, v0 and the offset can explain
    bool finite = false;         ///< false: m, b, k or the sample time are outside the range of numbers
};

/// Exact for the declared hold: with m w'' + b w' + k w = x, d x / d m = -w'', d x / d b = -w', d x / d k =
/// -w, all from one matrix exponential of the cascade (x, x', w, w'). m, b, k and the sample time must be
/// positive.
[[nodiscard]] ResponseSensitivities responseSensitivities(const MassDampingStiffness& parameters,
                                                          std::span<const double> force,
                                                          const SensitivityOptions& options);

/// J'(I - Q Q')J, J the sensitivities to the logarithms, Q the nuisances: the Fisher information on
/// (ln m, ln b, ln k) from position noise of variance 1. Its inverse times the noise's variance is the
/// Cramer-Rao bound on their covariance (Ljung, System Identification, 2nd ed., section 7.4).
[[nodiscard]] Eigen::Matrix3d fisherInformation(const ResponseSensitivities& sensitivities);

/// Standard deviations of m, b and k no unbiased estimator can go below with white Gaussian position noise of
/// this deviation; nothing when the force does not determine all three.
[[nodiscard]] std::optional<Eigen::Vector3d> cramerRaoBound(const MassDampingStiffness& parameters,
                                                            std::span<const double> force,
                                                            const SensitivityOptions& options,
                                                            double noiseDeviation);

/// The inverse of a symmetric positive definite matrix whose rows may differ in size by any factor; nothing
/// when it is singular to rounding (condition above 1e14 once scaled).
[[nodiscard]] std::optional<Eigen::Matrix3d> inverseInformation(const Eigen::Matrix3d& information);

} // namespace gripscope
