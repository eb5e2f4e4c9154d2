// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/identification/lag_alignment.h"

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <vector>

namespace gripscope {

/// The output-error problem in units of its own: time in samples, force and position divided by a power of
/// two near their largest value (so that nothing is rounded and no square overflows), position less
/// `positionShift`. The parameters are the logarithms theta = (ln M, ln B, ln K) of M x'' + B x' + K x = F in
/// these units.
struct OutputErrorProblem {
    std::vector<double> force, position;
    ForceHold hold = ForceHold::First;
    LagAlignment lag;
    bool freeInitialState = true, freeOffset = true;
    double sampleTime_s = 1, forceScale = 1, positionScale = 1, positionShift = 0;

    /// Rows whose position lies within the time the force is known: [firstRow, endRow).
    [[nodiscard]] std::ptrdiff_t firstRow() const;
    [[nodiscard]] std::ptrdiff_t endRow() const;
    [[nodiscard]] std::ptrdiff_t rows() const { return std::max<std::ptrdiff_t>(endRow() - firstRow(), 0); }
    /// How many of x0, v0, offset are free.
    [[nodiscard]] int nuisanceCount() const { return (freeInitialState ? 2 : 0) + (freeOffset ? 1 : 0); }

    [[nodiscard]] MassDampingStiffness toChannelUnits(const Eigen::Vector3d& theta) const;
    [[nodiscard]] Eigen::Vector3d toTheta(const MassDampingStiffness& parameters) const;
};

/// x0, v0 and offset in the problem's units; zero where they are not free.
struct ScaledNuisance {
    double x0 = 0, v0 = 0, offset = 0;
};

/// The best x0, v0 and offset for given m, b, k: they enter linearly, so that they are one linear
/// least-squares solution away (variable projection, Golub and Pereyra 1973).
struct ResponseFit {
    bool finite = false;
    double cost = 0; ///< sum of squared residuals
    ScaledNuisance nuisance;
    int nuisanceRank = 0;
    /// The factor on the forced response (the compliance) that would fit best, and the cost with it.
    double gain = 1, costWithGain = 0;
    /// The share of the forced response that x0, v0 and offset cannot imitate: at rounding level for a
    /// constant force.
    double ownShare = 0;
};
[[nodiscard]] ResponseFit fitResponse(const OutputErrorProblem& problem, const Eigen::Vector3d& theta);

/// The problem linearised in theta, with everything that x0, v0 and offset can explain projected out.
struct Linearization {
    bool finite = false;
    Eigen::MatrixXd sensitivities; ///< R factor, 3 columns: d x / d theta
    Eigen::VectorXd residual;      ///< its right-hand side
};
[[nodiscard]] Linearization linearize(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                                      const ScaledNuisance& nuisance);

/// Calls `use(row, columns)` for every row of the linearised problem, columns being x0, v0, offset (those
/// that are free), ln M, ln B, ln K and the residual.
void forEachLinearizedRow(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                          const ScaledNuisance& nuisance,
                          const std::function<void(std::ptrdiff_t, const Eigen::RowVectorXd&)>& use);

} // namespace gripscope
