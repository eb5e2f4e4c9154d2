// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error_problem.h"
#include "core/math/levenberg_marquardt.h"

#include <vector>

namespace gripscope {

/// The auxiliary model theta = (ln M, ln B, ln K) with the x0, v0 and offset that fit it best.
struct AuxiliaryModel {
    bool finite = false;
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();
    double x0 = 0, v0 = 0, offset = 0;
    int nuisanceRank = 0;
    double cost = 0; ///< sum of squared residuals of its simulation
    /// The factor on the forced response (the compliance) that would fit best.
    double gain = 1;
    /// The share of the forced response that x0, v0 and offset cannot imitate.
    double ownShare = 0;
};
[[nodiscard]] AuxiliaryModel auxiliaryModel(const OutputErrorProblem& record, const Eigen::Vector3d& theta);

/// The instrumental-variable equations at an auxiliary model, in coordinates that leave out what x0, v0 and
/// offset explain. Columns belong to ln M, ln B, ln K: M f(x''), B f(x'), K f(x) of the model, and of the
/// measurement.
struct InstrumentalEquations {
    bool finite = false;
    Eigen::MatrixXd instruments; ///< 3 columns
    Eigen::MatrixXd regressors;  ///< 3 columns
    Eigen::VectorXd residual;    ///< of the model's simulation
};
[[nodiscard]] InstrumentalEquations instrumentalEquations(const OutputErrorProblem& record,
                                                          const AuxiliaryModel& model);

/// All measured rows: free nuisance columns, then the instruments; and the residuals.
struct InstrumentRows {
    Eigen::MatrixXd columns;
    std::vector<double> residuals;
};
[[nodiscard]] InstrumentRows instrumentRows(const OutputErrorProblem& record, const AuxiliaryModel& model);

struct InstrumentalResult : SearchEnd {
    AuxiliaryModel model;
    InstrumentalEquations equations;                 ///< at the model
    Eigen::Matrix3d cross = Eigen::Matrix3d::Zero(); ///< Q'W: instruments Z = Q R, regressors W

    [[nodiscard]] double cost() const { return model.cost; }
    [[nodiscard]] bool isDetermined() const;
    [[nodiscard]] bool isSettled() const { return outcome == SearchOutcome::Converged && isDetermined(); }
    [[nodiscard]] double degreesOfFreedom(const OutputErrorProblem& record) const
    {
        return static_cast<double>(
            std::max<std::ptrdiff_t>(record.measuredRows() - 3 - model.nuisanceRank, 1));
    }
};

/// From one auxiliary model to the next until the instruments leave 1e-8 standard errors to go; where they do
/// not help, LevenbergMarquardt with the instruments for regressors.
[[nodiscard]] InstrumentalResult iterateInstruments(const OutputErrorProblem& record,
                                                    const Eigen::Vector3d& start, int maxIterations);

/// ln (M, B, K) of least squares on state-variable filters with unstable poles reflected, the compliance
/// refitted; the one whose simulation fits best first.
[[nodiscard]] std::vector<Eigen::Vector3d> instrumentalStarts(const OutputErrorProblem& record);

} // namespace gripscope
