// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/model/lag_alignment.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gripscope {

/// The output-error problem, which serves others that simulate the response too, in units of its own: time in
/// samples, force and position divided by a power of two near their largest value (so that nothing is rounded
/// and no square overflows), position less `positionShift`. The parameters are the logarithms theta = (ln M,
/// ln B, ln K) of M x'' + B x' + K x = F in these units.
struct OutputErrorProblem {
    std::vector<double> force, position; ///< interpolated where nothing was measured
    std::vector<std::size_t> lost;       ///< sorted indexes where nothing was measured
    /// Of the lost forces from their interpolation (lostForcePrior()): each adds the row (lost force -
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
    [[nodiscard]] bool isLost(std::ptrdiff_t index) const
    {
        return !lost.empty() && std::binary_search(lost.begin(), lost.end(), static_cast<std::size_t>(index));
    }
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
                                                        const ContinuousTimeOptions& options);

/// x0, v0 and offset in channel units, those that are free.
[[nodiscard]] Nuisance nuisanceInChannelUnits(const OutputErrorProblem& record, double x0, double v0,
                                              double offset);

/// The sum of squares of the positions.
[[nodiscard]] double squaredSize(const OutputErrorProblem& record);
/// The same, less their mean where the offset is free.
[[nodiscard]] double positionEnergy(const OutputErrorProblem& record);

/// Its first samples, at most `most`.
[[nodiscard]] OutputErrorProblem firstSamples(const OutputErrorProblem& record, std::size_t most);

[[nodiscard]] bool isConstant(const std::vector<double>& values);

/// Fills in residuals, fits and the tests of the residuals from `estimate.simulated` (channel units, as long
/// as `position`). `columns` are the derivatives of the positions in the record's units, nuisances first, a
/// row a measured sample from firstRow() to endRow(); `residuals` belong to them. Fitted parameters are
/// accounted for by the columns (score test).
void describeResiduals(const OutputErrorProblem& record, const std::vector<double>& position,
                       const Eigen::MatrixXd& columns, const std::vector<double>& residuals,
                       Estimate& estimate);

/// The unknowns that enter the response linearly, in the problem's units; zero where they are not free.
struct ScaledNuisance {
    double x0 = 0, v0 = 0, offset = 0;
    std::vector<double> lostForces; ///< one for every lost sample
};

/// What a record itself says about the forces that were lost in it.
struct LostForcePrior {
    std::vector<double> force;     ///< the whole record, the lost values interpolated
    std::vector<double> deviation; ///< of each lost force from its interpolation, one standard deviation
};

/// Interpolates every gap on a straight line between its neighbours, or on a cubic through two on either
/// side, whichever fits better where the same gap is laid over measured samples. There the errors e are
/// measured as well: e^2 = a + c d^2, d the difference of the neighbours (a binary force errs only where d is
/// not zero). A variance never seen is taken for that of the force over one more than the places tried. In a
/// gap of several samples the errors may all go the same way, which counts more than their sizes: variances
/// are multiplied by the ratio measured of E (sum e)^2 to sum E e^2, 1 to the gap's length.
///
/// A force without any prior would cost much more: a response that is slow beside the sample time says
/// little about a single force. `lost` is sorted, within the record, and not all of it; the values there are
/// ignored. Deviations are positive.
[[nodiscard]] LostForcePrior lostForcePrior(const std::vector<double>& force,
                                            const std::vector<std::size_t>& lost);

} // namespace gripscope
