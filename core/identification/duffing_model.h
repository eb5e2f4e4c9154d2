// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/scaled_record.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// The problem of the cubic spring: the record, and how finely the motion is integrated.
struct DuffingProblem : ScaledRecord {
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

/// All sensitivities, a row a position from firstRow() to endRow(), and the residuals.
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

} // namespace gripscope
