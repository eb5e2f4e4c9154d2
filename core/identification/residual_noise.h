// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/force_noise.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace gripscope {

/// Noise that was found in the residuals of least squares and what it makes of the errors.
struct ResidualNoise {
    AutoregressiveNoise noise;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of the three parameters of interest
    int fittedNumbers = 0; ///< the noise model's own, for the tests that follow
};

/// Which noise the residuals hold: white, autoregressive, or white noise of the force channel besides that of
/// the position; the last two by the Bayesian criterion on restricted likelihoods. Nothing: white, and the
/// usual s^2 (J'J)^-1 holds. A noise model is taken only when Ljung-Box gives `whitenessP` below 0.001 or
/// when the likelihood ratio for noise of the force (one variance, on the edge of its range: half a
/// chi-square with one degree of freedom) has a p-value below 0.0025.
///
/// `basis`: orthonormal rows that span the sensitivities; `gains`: three rows, how the parameters of interest
/// come from the basis' coordinates.
[[nodiscard]] std::optional<ResidualNoise> findResidualNoise(std::span<const double> residuals,
                                                             const Eigen::MatrixXd& basis,
                                                             const Eigen::MatrixXd& gains,
                                                             const ForceResponse& response,
                                                             std::optional<double> whitenessP);

} // namespace gripscope
