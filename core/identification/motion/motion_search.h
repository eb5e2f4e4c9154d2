// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/motion_model.h"
#include "core/math/levenberg_marquardt.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace gripscope {

/// Where the search can begin, the candidate whose simulation fits best first; at most three.
///  - Least squares on state-variable filters of some bandwidths (Young 1981) of the equation itself, with
///    the sign of the filtered speed for friction and, for relaxation, some times tau.
///  - From `other`, m, b and k of the linear motion (0 where none), with some shares of the further terms.
[[nodiscard]] std::vector<MotionPoint> motionStarts(const MotionProblem& problem, const MotionPoint& other);

/// The point of another stretch of the same motion, begun where this one does.
[[nodiscard]] MotionPoint startNear(const MotionProblem& problem, const MotionPoint& other);
/// The slope of a straight line through the first positions, a sample.
[[nodiscard]] double startSpeed(const MotionProblem& problem);

/// Lost: the motion from the start leaves all bounds. boundaryIndex: of the problem's parameters.
struct MotionSearchResult : SearchEnd {
    MotionPoint point;
    MotionLinearization linear; ///< at the point

    [[nodiscard]] double cost() const { return linear.cost; }
    [[nodiscard]] bool isDetermined() const;
    [[nodiscard]] bool isSettled() const { return outcome == SearchOutcome::Converged && isDetermined(); }
    [[nodiscard]] static double degreesOfFreedom(const MotionProblem& problem)
    {
        return static_cast<double>(std::max<std::ptrdiff_t>(problem.measuredRows() - problem.unknowns(), 1));
    }
};

struct MotionSearchOptions {
    int maxIterations = 40;
    double arrived = 1e-6; ///< the step still to go, in standard errors
    /// The cost of an answer that is known: a search that will end no lower is given up, NotConverged.
    std::optional<double> lowest = {};
};

/// LevenbergMarquardt over all unknowns together. Friction that wants to be below zero stays at zero and out
/// of the search, until it no longer does.
[[nodiscard]] MotionSearchResult searchMotion(const MotionProblem& problem, const MotionPoint& start,
                                              const MotionSearchOptions& options);

} // namespace gripscope
