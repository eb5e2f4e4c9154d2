// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error_problem.h"
#include "core/math/levenberg_marquardt.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// The problem of the cubic spring: the record, and how finely the motion is integrated.
struct DuffingProblem : OutputErrorProblem {
    int substeps = 1; ///< steps of the integration a sample

    [[nodiscard]] int unknowns() const { return nuisanceCount() + 4; }
};

/// A point of the search, in the problem's units: theta = (ln M, ln B, ln K) and the cubic stiffness K3,
/// which may be negative.
struct DuffingPoint {
    double x0 = 0, v0 = 0, offset = 0;
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();
    double cubic = 0;

    [[nodiscard]] bool finite() const;
    /// Moved by a step in the order of the columns below.
    [[nodiscard]] DuffingPoint moved(const DuffingProblem& problem, const Eigen::VectorXd& step) const;
};

/// What K3 = 1 is in channel units.
[[nodiscard]] double cubicUnit(const DuffingProblem& problem);

/// The problem linearised at a point. Columns: those of x0, v0, offset that are free, ln M, ln B, ln K, K3:
/// the exact derivatives of the positions as they are integrated.
struct DuffingLinearization {
    bool finite = false;
    double cost = 0;           ///< sum of squared residuals
    Eigen::MatrixXd triangle;  ///< R factor of the sensitivities
    Eigen::VectorXd residual;  ///< the residuals' part in its coordinates
    Eigen::MatrixXd projected; ///< 4 columns: what is left of those of M, B, K, K3 beside the nuisances
    int nuisanceRank = 0;
};
[[nodiscard]] DuffingLinearization linearize(const DuffingProblem& problem, const DuffingPoint& point);

/// All sensitivities, a row a measured position from firstRow() to endRow(), and the residuals.
struct DuffingRows {
    Eigen::MatrixXd sensitivities;
    std::vector<double> residuals;
};
[[nodiscard]] DuffingRows duffingRows(const DuffingProblem& problem, const DuffingPoint& point);

/// Sum of squared residuals; nothing when the motion leaves all bounds.
[[nodiscard]] std::optional<double> costAt(const DuffingProblem& problem, const DuffingPoint& point);

/// x + offset at every position's time; before the first force x0 + offset, after the last one its force is
/// held. Empty when the motion leaves all bounds.
[[nodiscard]] std::vector<double> positionsAt(const DuffingProblem& problem, const DuffingPoint& point);

/// Steps a sample that take at most a third of a radian of the natural frequency that the stiffest point of a
/// motion of size `reach` has; 1 to 64.
[[nodiscard]] int suitableSubsteps(const DuffingPoint& point, double reach);

/// Where the search for a cubic spring can begin, the candidate whose simulation fits best first; at most
/// three.
///  - Least squares on state-variable filters of some bandwidths (Young 1981), M f(y'') + B f(y') + c3 f(y^3)
///  +
///    c2 f(y^2) + c1 f(y) + c0 = f(F), c2 and c0 for a free offset, which is the static position without
///    force.
///  - From each of `others`, and from it with a part of its spring turned into a cubic one by harmonic
///    balance: a spring k that fits a motion of amplitude a is K + 3/4 K3 a^2 (Duffing 1918).
[[nodiscard]] std::vector<DuffingPoint> duffingStarts(const DuffingProblem& problem,
                                                      const std::vector<DuffingPoint>& others);

/// Lost: the motion from the start leaves all bounds.
struct DuffingSearchResult : SearchEnd {
    DuffingPoint point;
    DuffingLinearization linear; ///< at the point

    [[nodiscard]] double cost() const { return linear.cost; }
    [[nodiscard]] bool isDetermined() const;
    [[nodiscard]] bool isSettled() const { return outcome == SearchOutcome::Converged && isDetermined(); }
    [[nodiscard]] double degreesOfFreedom(const DuffingProblem& problem) const
    {
        return static_cast<double>(
            std::max<std::ptrdiff_t>(problem.measuredRows() - 4 - linear.nuisanceRank, 1));
    }
};

/// LevenbergMarquardt to 1e-8 standard errors over all unknowns together: a cubic spring takes x0 and v0 out
/// of the linear ones.
[[nodiscard]] DuffingSearchResult searchDuffing(const DuffingProblem& problem, const DuffingPoint& start,
                                                int maxIterations);

} // namespace gripscope
