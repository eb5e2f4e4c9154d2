// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error_model.h"

namespace gripscope {

/// What the residuals of output error say about the model.
struct OutputErrorResiduals {
    std::optional<double> whitenessP, inputIndependenceP, errorInflation;
};

/// The tests of residual_tests.h at a solution. All absent when the residuals are rounding errors (below 1e-9
/// of the position's size), which are neither white nor noise.
[[nodiscard]] OutputErrorResiduals testOutputError(const OutputErrorProblem& problem,
                                                   const Eigen::Vector3d& theta,
                                                   const ScaledNuisance& nuisance);

} // namespace gripscope
