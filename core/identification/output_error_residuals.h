// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error_model.h"

namespace gripscope {

/// What the residuals of output error say about the model and about its errors.
struct OutputErrorResiduals {
    ResidualSummary summary; ///< but for sse and degrees of freedom
    /// Where the residuals are not white: the noise, in channel units, and the covariance of (ln m, ln b, ln
    /// k) under it.
    std::optional<AutoregressiveNoise> noise;
    std::optional<Eigen::Matrix3d> logCovariance;
};

/// The noise model of residual_noise.h and the tests of residual_tests.h at a solution; where a noise model
/// was found, the tests of input, feedback and spring are made on whitened rows. Where samples were lost all
/// of it is done on the rows that are left when the lost forces are taken out (output_error_rows.h):
/// residuals at and next to a lost sample are not white, those rows are. No noise model where a start or an
/// offset that was fixed at zero is certainly there: what is left of it is no noise. Everything absent when
/// the residuals are rounding errors (below 1e-9 of the position's size), which are neither white nor noise.
[[nodiscard]] OutputErrorResiduals testOutputError(const OutputErrorProblem& problem,
                                                   const Eigen::Vector3d& theta,
                                                   const ScaledNuisance& nuisance);

} // namespace gripscope
