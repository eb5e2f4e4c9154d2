// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/identification/lag_alignment.h"
#include "core/identification/output_error.h"

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace gripscope {

/// The output-error problem in units of its own: time in samples, force and position divided by a power of
/// two near their largest value (so that nothing is rounded and no square overflows), position less
/// `positionShift`. The parameters are the logarithms theta = (ln M, ln B, ln K) of M x'' + B x' + K x = F in
/// these units.
struct OutputErrorProblem {
    std::vector<double> force, position; ///< interpolated where nothing was measured
    std::vector<std::size_t> lost;       ///< sorted indexes where nothing was measured
    /// Of the lost forces from their interpolation (lost_force_prior.h): each adds the row (lost force -
    /// interpolation) noise / deviation to the sum of squares.
    std::vector<double> lostForceDeviation;
    double noiseDeviation = 0; ///< of the position; to be found along with the parameters
    ForceHold hold = ForceHold::First;
    LagAlignment lag;
    bool freeInitialState = true, freeOffset = true;
    double sampleTime_s = 1, forceScale = 1, positionScale = 1, positionShift = 0;

    /// Rows whose position lies within the time the force is known: [firstRow, endRow).
    [[nodiscard]] std::ptrdiff_t firstRow() const;
    [[nodiscard]] std::ptrdiff_t endRow() const;
    [[nodiscard]] std::ptrdiff_t rows() const { return std::max<std::ptrdiff_t>(endRow() - firstRow(), 0); }
    /// Those of them that were measured.
    [[nodiscard]] std::ptrdiff_t measuredRows() const;
    /// Terms of the sum of squares: the measured rows and, given a noise, one for every lost force.
    [[nodiscard]] std::ptrdiff_t terms() const
    {
        return measuredRows() + (noiseDeviation > 0 ? static_cast<std::ptrdiff_t>(lost.size()) : 0);
    }
    /// How many of x0, v0, offset are free.
    [[nodiscard]] int nuisanceCount() const { return (freeInitialState ? 2 : 0) + (freeOffset ? 1 : 0); }

    [[nodiscard]] MassDampingStiffness toChannelUnits(const Eigen::Vector3d& theta) const;
    [[nodiscard]] Eigen::Vector3d toTheta(const MassDampingStiffness& parameters) const;
};

/// Force and position must be equally long and not empty; lost indexes beyond them do not count.
[[nodiscard]] OutputErrorProblem makeOutputErrorProblem(const std::vector<double>& force,
                                                        const std::vector<double>& position,
                                                        const OutputErrorOptions& options);

/// The unknowns that enter the response linearly, in the problem's units; zero where they are not free.
struct ScaledNuisance {
    double x0 = 0, v0 = 0, offset = 0;
    std::vector<double> lostForces; ///< one for every lost sample
};

} // namespace gripscope
