// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/duffing_model.h"

namespace gripscope {

enum class DuffingOutcome {
    Converged,
    NotConverged,
    Boundary, ///< the best value of one of M, B, K is zero or infinite
    Lost,     ///< the motion from the start leaves all bounds
};

struct DuffingSearchResult {
    DuffingOutcome outcome = DuffingOutcome::NotConverged;
    DuffingPoint point;
    DuffingLinearization linear; ///< at the point
    int iterations = 0;
    int boundaryIndex = 0; ///< 0 for M, 1 for B, 2 for K
    bool boundaryAtZero = true;

    [[nodiscard]] double degreesOfFreedom(const DuffingProblem& problem) const
    {
        return static_cast<double>(std::max<std::ptrdiff_t>(problem.rows() - 4 - linear.nuisanceRank, 1));
    }
};

/// Levenberg-Marquardt (More 1978, with Marquardt's scaling) over all unknowns together: a cubic spring takes
/// x0 and v0 out of the linear ones. Ends when the step still to go is 1e-8 standard errors (relative offset
/// criterion, Bates and Watts 1981), when it is lost in rounding, or when the logarithm of a parameter runs
/// away.
[[nodiscard]] DuffingSearchResult searchDuffing(const DuffingProblem& problem, const DuffingPoint& start,
                                                int maxIterations);

} // namespace gripscope
