// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/motion.h"
#include "core/identification/motion/motion_model.h"
#include "core/identification/output_error/completed_record.h"
#include "core/math/levenberg_marquardt.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace gripscope {

/// A motion's problem with every force known. At lost samples these are what output error finds; where the
/// terms have no mass or no spring, which output error does not know, straight lines where it finds nothing.
struct KnownForces {
    CompletedRecord completed;
    MotionProblem problem;
    double errorFactor = 1; ///< by which the errors grow because lost forces had to be found

    /// Nothing was lost, or what was lost has been found; else `completed.outputError` says why not.
    [[nodiscard]] bool areKnown() const
    {
        return completed.lost.empty() || completed.outputError.parameters.has_value();
    }
};

[[nodiscard]] KnownForces knownForces(const std::vector<double>& force, const std::vector<double>& position,
                                      const MotionOptions& options);

/// The lost forces once more, from positions without what the further terms of `found` add to the motion of
/// its m, b and k. Nothing where no sample was lost, or where output error finds no forces.
[[nodiscard]] std::optional<KnownForces> knownForcesAgain(const KnownForces& known, const Estimate& found,
                                                          const MotionOptions& options);

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

// The errors of a motion's parameters where its search ended. `scales`: errorScales().

/// What the parameters' variances are in: 1 for a logarithm is the parameter itself.
[[nodiscard]] Eigen::VectorXd errorScales(const MotionProblem& problem, const MotionPoint& point);

/// (S'S)^-1 S' of the parameters, in the channels' units: a row a sample, zero where it was not measured.
[[nodiscard]] Eigen::MatrixXd influencesOf(const MotionProblem& problem, const MotionSearchResult& search,
                                           const MotionRows& rows, const Eigen::VectorXd& scales);

/// s^2 (J'J)^-1 of the parameters; nothing where it is no covariance.
[[nodiscard]] std::optional<Eigen::MatrixXd> whiteCovariance(const MotionProblem& problem,
                                                             const MotionSearchResult& search,
                                                             const Eigen::VectorXd& scales);

/// With what is known of the friction as one more, independent measurement of it, of this variance.
[[nodiscard]] Eigen::MatrixXd withKnownFriction(const Eigen::MatrixXd& covariance, Eigen::Index friction,
                                                double variance);

/// Under the autoregressive noise that the residuals hold, which becomes that of the estimate; nothing where
/// they hold none.
[[nodiscard]] std::optional<Eigen::MatrixXd> colouredCovariance(const MotionRows& rows,
                                                                const Eigen::VectorXd& scales,
                                                                double positionScale, Estimate& estimate);

/// How large the friction may be: the best value were it free to be below zero, and 1.645 of its errors.
/// Nothing where the motion has none.
[[nodiscard]] std::optional<double> frictionLimit(const MotionProblem& problem,
                                                  const MotionSearchResult& search, const MotionValues& found,
                                                  const Eigen::MatrixXd& covariance);

} // namespace gripscope
