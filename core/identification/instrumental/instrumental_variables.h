// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/math/levenberg_marquardt.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gripscope {

/// How to find m, b, k by refined instrumental variables.
struct InstrumentalVariablesOptions : ContinuousTimeOptions {
    int maxIterations = 60;
};

/// The simplified refined instrumental variable method in continuous time (SRIVC: Young and Jakeman 1979;
/// Garnier and Wang, Identification of Continuous-time Models from Sampled Data, 2008, ch. 4). With
/// A(s) = m s^2 + b s + k of the iteration before and f = 1/A,
///     m f(y'') + b f(y') + k f(y) = f(F) + what x0, v0 and the offset add,
/// is solved with the noise-free model's f(x''), f(x'), f(x) for instruments, x the response to the force as
/// it is held; free responses of A and a constant stand for x0, v0 and offset. At the fixed point the
/// instruments are orthogonal to the simulation's residual: it is the output-error estimate, found another
/// way.
///
/// The known weakness is an auxiliary model that is unstable or far off, whose instruments are then worthless
/// (heavy tails). Here poles of a first estimate are reflected into the stable half plane and their damping
/// kept above 1 %, every step must lower the simulation's error, is shortened until it does, and gives way to
/// a step with the instruments for regressors (Gauss-Newton) where it cannot.
///
/// `covariance` = s^2 (Z'Phi)^-1 Z'Z (Phi'Z)^-1, Z the instruments, Phi the regressors, what the nuisances
/// explain taken out of both; s^2 = SSE / (N - p). Conventions and statuses as for estimateOutputError().
///
/// Where samples were lost their forces are those that output error finds (completedRecord()), which leaves
/// the fixed point where it is, and their rows are skipped; the errors grow as those of output error do.
[[nodiscard]] Estimate estimateInstrumentalVariables(const std::vector<double>& force,
                                                     const std::vector<double>& position,
                                                     const InstrumentalVariablesOptions& options);

// The search: from one auxiliary model to the next.

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
