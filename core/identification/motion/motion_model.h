// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/motion_terms.h"
#include "core/identification/output_error/output_error_problem.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// What is known of the friction beforehand, in the problem's units: one more residual, weight (value - Fc).
struct FrictionPrior {
    double value = 0;
    double weight = 0; ///< deviation of the positions' noise over that of the value
};

/// The problem of a motion with these terms, in the units of OutputErrorProblem.
struct MotionProblem : OutputErrorProblem {
    MotionTerms terms;
    /// Friction holds a part at the start: its speed then moves nothing, and next to nothing where it is
    /// small.
    bool startsAtRest = false;
    std::optional<FrictionPrior> frictionPrior = {}; ///< only where the terms have friction

    /// Without a spring no position is special: the start is the offset.
    [[nodiscard]] bool seeksPosition() const { return freeInitialState && terms.spring; }
    [[nodiscard]] bool seeksSpeed() const { return freeInitialState && terms.mass && !startsAtRest; }
    [[nodiscard]] bool seeksStrain() const { return freeInitialState && terms.relaxation; }
    [[nodiscard]] bool seeksOffset() const { return freeOffset || !terms.spring; }
    /// How many of x0, v0, x0 - q0 and the offset are free: the first unknowns.
    [[nodiscard]] int startUnknowns() const;
    [[nodiscard]] int unknowns() const;
    /// The place of one of its parameters among the unknowns.
    [[nodiscard]] Eigen::Index columnOf(MotionParameter parameter) const;
    /// The prior's residual at a value of the friction; 0 without a prior.
    [[nodiscard]] double priorResidual(double friction) const;
    /// What 1 in the problem's units is in those of the channels.
    [[nodiscard]] double unitOf(MotionParameter parameter) const;
};

/// A point of the search, in the problem's units; positive parameters as they are, not as logarithms.
struct MotionPoint {
    double x0 = 0, v0 = 0, strain0 = 0, offset = 0;
    MotionValues values;

    [[nodiscard]] bool isPhysical(const MotionTerms& terms) const;
    /// Moved by a step in the order of the columns below: positive parameters by a factor exp(step), friction
    /// not below zero.
    [[nodiscard]] MotionPoint moved(const MotionProblem& problem, const Eigen::VectorXd& step) const;
};

/// The parameters in the units of the channels, and back.
[[nodiscard]] MotionValues inChannelUnits(const MotionProblem& problem, const MotionValues& values);
[[nodiscard]] MotionValues inProblemUnits(const MotionProblem& problem, const MotionValues& values);

/// The problem linearised at a point. Columns: x0, v0, x0 - q0, offset as far as they are free, then the
/// parameters in their order, those that are positive by their logarithm: the exact derivatives of the
/// positions as they are integrated.
struct MotionLinearization {
    bool finite = false;
    double cost = 0;          ///< sum of squared residuals, the prior's among them
    Eigen::MatrixXd triangle; ///< R factor of the sensitivities
    Eigen::VectorXd residual; ///< the residuals' part in its coordinates
    Eigen::Index startUnknowns = 0;

    /// The columns that are not zero: the start's speed moves nothing while the part sticks.
    [[nodiscard]] std::vector<Eigen::Index> moving() const;
    /// No parameter's column is zero: friction on the way back is, where nothing ever moves back.
    [[nodiscard]] bool movesEveryParameter() const;
};
[[nodiscard]] MotionLinearization linearize(const MotionProblem& problem, const MotionPoint& point);

/// All sensitivities, a row a measured position from firstRow() to endRow(), and the residuals; no prior.
struct MotionRows {
    Eigen::MatrixXd sensitivities;
    std::vector<double> residuals;
};
[[nodiscard]] std::optional<MotionRows> motionRows(const MotionProblem& problem, const MotionPoint& point);

struct MotionCost {
    double cost = 0; ///< sum of squared residuals, the prior's among them
    double mean = 0; ///< of the positions' residuals
};
/// Nothing when the motion leaves all bounds.
[[nodiscard]] std::optional<MotionCost> costAt(const MotionProblem& problem, const MotionPoint& point);

/// x + offset at every position's time; before the first force the start, after the last one its force is
/// held. Empty when the motion leaves all bounds.
[[nodiscard]] std::vector<double> positionsAt(const MotionProblem& problem, const MotionPoint& point);

} // namespace gripscope
