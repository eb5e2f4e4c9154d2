// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// Ljung-Box: p-value of the hypothesis that the residuals are white, from Q = N (N + 2) sum r_k^2 / (N - k)
/// over the first N / 40 autocorrelations (3 to 20) and as many more as `fittedLags`, chi-square with lags -
/// fittedLags degrees of freedom (Ljung and Box 1978; fittedLags: the coefficients of a noise model that were
/// fitted, 0 for output error). `basis`: orthonormal rows that span the sensitivities of the regression the
/// residuals come from (empty: none); the r_k are freed of what these take out of white noise on the average,
/// -s^2 tr(Q S_k Q'), without which the test finds colour where there is none. Nothing when there are too few
/// residuals or when they do not vary.
[[nodiscard]] std::optional<double> ljungBoxP(std::span<const double> residuals, int fittedLags,
                                              const Eigen::MatrixXd& basis = {});

/// Standard normal score of the hypothesis that the residuals hold, besides white noise, a share of noise
/// with the autocorrelation `shape` (lags 0, 1, ...): sum of shape_k r_k over its standard deviation, the
/// locally best test. Nothing when it is not defined.
[[nodiscard]] std::optional<double>
noiseScore(std::span<const double> residuals, const Eigen::MatrixXd& basis, const std::vector<double>& shape);

/// The lags, in samples, at which past and present input is held against the residuals, and those at which
/// future input is: a residual that future force knows of is force that answers to the position.
inline constexpr std::array<std::size_t, 8> inputLags{0, 1, 2, 4, 8, 16, 32, 64};
inline constexpr std::array<std::size_t, 4> inputLeads{1, 2, 4, 8};

/// The input at those lags before (leads after) every sample from `first` to `first + count`, a row a lag;
/// the first sample stands for what was before it, the last for what came after.
[[nodiscard]] Eigen::MatrixXd pastInputs(std::span<const double> input, std::ptrdiff_t first,
                                         std::ptrdiff_t count);
[[nodiscard]] Eigen::MatrixXd futureInputs(std::span<const double> input, std::ptrdiff_t first,
                                           std::ptrdiff_t count);

/// What extra regressors explain of the residuals.
struct ExplainedTest {
    double p = 1; ///< of the hypothesis that they explain nothing
    double f = 0; ///< what they explain, a regressor, over the variance of what is left
};
/// The F test of nested regressions: `extra` are orthonormal rows, orthogonal to `model`, which are
/// orthonormal too. Exact for a linear model with white Gaussian noise; for output error, whose rows are the
/// sensitivities, it is the score test, so that fitted parameters are accounted for. Nothing when no samples
/// or no rows are left.
[[nodiscard]] std::optional<ExplainedTest> testExplained(const Eigen::RowVectorXd& residuals,
                                                         const Eigen::MatrixXd& model,
                                                         const Eigen::MatrixXd& extra);

/// The same from the coordinates of `count` residuals of that power (sum of squares) in both bases.
[[nodiscard]] std::optional<ExplainedTest> testExplained(double power, Eigen::Index count,
                                                         const Eigen::VectorXd& fitted,
                                                         const Eigen::VectorXd& explained);

/// The input at those lags before sample t, the first sample standing for what was before it.
[[nodiscard]] Eigen::RowVector<double, inputLags.size()> laggedInputs(std::span<const double> input,
                                                                      std::size_t t);

/// p-value of the hypothesis that the last `extraColumns` columns in front of the right-hand side explain
/// nothing that the columns before them do not: the F test of nested regressions, on the triangle of [model,
/// extra, rhs] of `rows` rows. Exact for a linear model with white Gaussian noise; for output error, whose
/// model columns are the sensitivities, it is the score test, so that fitted parameters are accounted for.
/// Columns that depend on others do not count. Nothing when no rows or no columns are left.
[[nodiscard]] std::optional<double> extraColumnsP(const Eigen::MatrixXd& triangle, Eigen::Index extraColumns,
                                                  double rows);

/// How many times larger the standard error of the worst parameter is when the correlation between the
/// residuals is counted: the sandwich (J'J)^-1 J' C J (J'J)^-1 with C from the autocovariances of the
/// residuals, tapered over 50 lags (Newey and West 1987), against s^2 (J'J)^-1. `sensitivities` has one row a
/// residual, nuisances projected out. Nothing when it is not defined.
[[nodiscard]] std::optional<double> errorInflation(const Eigen::MatrixXd& sensitivities,
                                                   std::span<const double> residuals);

} // namespace gripscope
