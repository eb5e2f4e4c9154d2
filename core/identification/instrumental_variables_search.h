// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/instrumental_variables_model.h"

#include <vector>

namespace gripscope {

enum class InstrumentalOutcome {
    Converged,
    NotConverged,
    Boundary, ///< the best value of one of M, B, K is zero or infinite
};

struct InstrumentalResult {
    InstrumentalOutcome outcome = InstrumentalOutcome::NotConverged;
    AuxiliaryModel model;
    InstrumentalEquations equations;                 ///< at the model
    Eigen::Matrix3d cross = Eigen::Matrix3d::Zero(); ///< Q'W: instruments Z = Q R, regressors W
    int iterations = 0;
    int boundaryIndex = 0; ///< 0 for M, 1 for B, 2 for K
    bool boundaryAtZero = true;

    [[nodiscard]] double degreesOfFreedom(const ScaledRecord& record) const
    {
        return static_cast<double>(std::max<std::ptrdiff_t>(record.rows() - 3 - model.nuisanceRank, 1));
    }
};

/// From one auxiliary model to the next until the instruments leave 1e-8 standard errors to go.
[[nodiscard]] InstrumentalResult iterateInstruments(const ScaledRecord& record, const Eigen::Vector3d& start,
                                                    int maxIterations);

/// ln (M, B, K) of least squares on state-variable filters with unstable poles reflected, the compliance
/// refitted; the one whose simulation fits best first.
[[nodiscard]] std::vector<Eigen::Vector3d> instrumentalStarts(const ScaledRecord& record);

} // namespace gripscope
