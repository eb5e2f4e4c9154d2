// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error_model.h"

namespace gripscope {

enum class SearchOutcome {
    Converged,
    NotConverged,
    Boundary, ///< the best value of one of M, B, K is zero or infinite
};

struct SearchResult {
    SearchOutcome outcome = SearchOutcome::NotConverged;
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();
    Linearization linear; ///< there
    int iterations = 0;
    int boundaryIndex = 0; ///< 0 for M, 1 for B, 2 for K
    bool boundaryAtZero = true;
};

/// Levenberg-Marquardt (More 1978, with Marquardt's scaling) on the problem with x0, v0, offset and lost
/// forces eliminated; one pass over the record an iteration.
/// Ends when the step still to go is 1e-9 standard errors (relative offset criterion, Bates and Watts 1981),
/// when it is lost in rounding, or when the logarithm of a parameter runs away.
[[nodiscard]] SearchResult searchOutputError(const OutputErrorProblem& problem, const Eigen::Vector3d& start,
                                             int maxIterations);

} // namespace gripscope
