// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"

#include <Eigen/Core>

namespace gripscope {

// Variances under a noise model are uncertain themselves, as the model is estimated: standard errors are
// multiplied so that they give 95 % intervals with the normal quantile.

/// The factor for one parameter: Student's t with f degrees of freedom, at least 3, over the normal quantile.
/// Var(ln variance) = `logVarianceSpread` of a chi-square is about 2 / f (Satterthwaite 1946). At least 1.
[[nodiscard]] double errorExpansion(double logVarianceSpread);

/// ln variances of the three parameters of interest under the noise. `basis`: orthonormal rows that span the
/// sensitivities; `gains`: three rows, how the parameters come from the basis' coordinates.
[[nodiscard]] Eigen::Vector3d logVariances(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& gains,
                                           const AutoregressiveNoise& noise);

/// The factors for an autoregressive model fitted to as many residuals as the basis has columns: its
/// coefficients scatter by variance Gamma^-1 / N (Box and Jenkins, section 7.2), Gamma their
/// autocovariances, and ln variance by 2 / N. 400 residuals with a correlation of 0.8: about 1.06 for the
/// stiffness, whose variance is that of the lowest frequencies. 1 with more than 20,000 residuals.
[[nodiscard]] Eigen::Vector3d autoregressiveExpansion(const Eigen::MatrixXd& basis,
                                                      const Eigen::MatrixXd& gains,
                                                      const AutoregressiveNoise& noise);

} // namespace gripscope
