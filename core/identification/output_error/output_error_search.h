// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error.h"
#include "core/identification/output_error/output_error_model.h"
#include "core/math/levenberg_marquardt.h"

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace gripscope {

/// Where the output-error search can begin, the candidate whose simulation fits best first.
struct OutputErrorStarts {
    std::vector<Eigen::Vector3d> bestFirst;
    bool trusted = false; ///< the first explains three quarters of the position's energy (a fit of 50 %)
};

/// Candidates from the data:
///  - least squares on state-variable filters of some bandwidths (Young 1981), m f_y'' + b f_y' + k f_y = f_u
///  with
///    f = signal / (1 + s/lambda)^2 and the filters' own free responses as extra columns, and
///  - the pole mapping of ARX(2,3,0), which is exact for a first-order hold.
/// The compliance of each is refitted, which is linear; those that then pull where the force pushes are
/// dropped.
[[nodiscard]] OutputErrorStarts outputErrorStarts(const OutputErrorProblem& problem);

/// Points that may be near the solution, the compliance of each refitted, which is linear; those that then
/// pull where the force pushes are dropped, and of the others the `most` that fit best are kept.
struct RankedCandidates {
    std::vector<Eigen::Vector3d> bestFirst;
    double leastCost = std::numeric_limits<double>::infinity(); ///< sum of squared residuals of the first
};
[[nodiscard]] RankedCandidates rankByResponse(const OutputErrorProblem& problem,
                                              const std::vector<Eigen::Vector3d>& candidates,
                                              std::size_t most);

/// Candidates for records that defeat those: the best points of a coarse grid over natural frequency (from a
/// twelfth of a swing a record to near half the sample rate) and damping, ranked on the first 2,000 samples.
/// Best first.
[[nodiscard]] std::vector<Eigen::Vector3d> outputErrorGrid(const OutputErrorProblem& problem);

struct SearchResult : SearchEnd {
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();
    Linearization linear; ///< there

    [[nodiscard]] double cost() const { return linear.cost; }
    /// What the search found is more than rounding.
    [[nodiscard]] bool isDetermined() const;
    /// The search ended at an optimum and the data determines it.
    [[nodiscard]] bool isSettled() const;
};

/// LevenbergMarquardt to `arrived` standard errors on the problem with x0, v0, offset and lost forces
/// eliminated; one pass over the record an iteration. Where that is slow, Newton's method.
[[nodiscard]] SearchResult searchOutputError(const OutputErrorProblem& problem, const Eigen::Vector3d& start,
                                             int maxIterations, double arrived);

/// M, B, K of theta.
[[nodiscard]] MassDampingStiffness scaledParameters(const Eigen::Vector3d& theta);

/// The linearised problem for the tests of its residuals: regressors as rows, a column a measured sample.
/// Where samples were lost their forces are taken out (withoutLostForces), which leaves white noise when that
/// of the position is.
class OutputErrorRows {
public:
    OutputErrorRows(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                    const ScaledNuisance& nuisance);

    /// x0, v0 and offset (those that are free), then ln M, ln B, ln K.
    [[nodiscard]] const Eigen::MatrixXd& sensitivities() const { return m_sensitivities; }
    [[nodiscard]] const Eigen::RowVectorXd& residual() const { return m_residual; }
    /// The model's position at every sample from firstRow() to endRow(), measured or not.
    [[nodiscard]] const Eigen::RowVectorXd& modelled() const { return m_modelled; }
    /// Other regressors, given at every sample from firstRow() to endRow(), as they stand beside these.
    [[nodiscard]] Eigen::MatrixXd rowsOf(Eigen::MatrixXd series) const;
    /// The residuals are below 1e-9 of the position's size, or nothing is finite.
    [[nodiscard]] bool isRounding() const;

private:
    void takeOutLost(const ScaledNuisance& nuisance);

    const OutputErrorProblem& m_problem;
    Eigen::Vector3d m_theta;
    Eigen::MatrixXd m_sensitivities;
    Eigen::RowVectorXd m_residual, m_modelled;
    double m_size = 0;
};

/// What the residuals of output error say about the model and about its errors.
struct OutputErrorResiduals {
    ResidualSummary summary; ///< but for sse and degrees of freedom
    /// Where the residuals are not white: the noise, in channel units, and the covariance of (ln m, ln b, ln
    /// k) under it.
    std::optional<AutoregressiveNoise> noise;
    std::optional<Eigen::Matrix3d> logCovariance;
};

/// The noise model of residual_noise.h and, as deep as `depth`, the tests of residual_tests.h at a solution;
/// where a noise model was found, the tests of input, feedback and spring are made on whitened rows. Where
/// samples were lost all of it is done on the rows that are left when the lost forces are taken out
/// (OutputErrorRows): residuals at and next to a lost sample are not white, those rows are. No noise model
/// where a start or an offset that was fixed at zero is certainly there: what is left of it is no noise.
/// Everything absent when the residuals are rounding errors (below 1e-9 of the position's size), which are
/// neither white nor noise.
[[nodiscard]] OutputErrorResiduals testOutputError(const OutputErrorProblem& problem,
                                                   const Eigen::Vector3d& theta,
                                                   const ScaledNuisance& nuisance, ResidualDepth depth);

} // namespace gripscope
