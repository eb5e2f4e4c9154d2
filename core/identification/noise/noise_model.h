// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace gripscope {

// Models of residuals that are not white, and what they do to the errors of least squares. All filters start
// from rest; series have one value a sample. Numbers must be finite; nothing here returns any other.

/// Autoregressive model by the Yule-Walker equations (Levinson's recursion, always stationary), order 0 to
/// min(20, N / 10) by the Bayesian criterion N ln(innovation variance) + order ln N (Schwarz 1978). Empty
/// coefficients: white. Fewer than 10 values or no variation: white as well.
///
/// For the residuals r = (I - Q Q') e of a least-squares fit, Q being an orthonormal basis of its
/// sensitivities, one row a parameter and one column a residual. What the parameters took out of the noise e
/// lies where they are sensitive, at low frequencies: the autocovariances are raised by as much as the model
/// says they lost, three times over. Without that the errors come out 10 to 20 % too small for 400 residuals.
/// An empty basis: the values are no residuals of a fit, only their mean is taken out.
[[nodiscard]] AutoregressiveNoise fitAutoregressiveNoise(std::span<const double> residuals,
                                                         const Eigen::MatrixXd& basis);

/// w[t] for every e[t], one row a series: the inverse of the noise model.
[[nodiscard]] Eigen::MatrixXd whitened(const Eigen::MatrixXd& series, const AutoregressiveNoise& noise);
[[nodiscard]] std::vector<double> whitened(std::span<const double> series, const AutoregressiveNoise& noise);

/// The restricted likelihood of the last row of `series`, the rows before being the regressors, under the
/// noise model but for its variance, which is profiled out.
struct RestrictedLikelihood {
    double minusTwiceLog = 0; ///< but for a constant
    double variance = 0;      ///< of the innovations
};
[[nodiscard]] std::optional<RestrictedLikelihood> restrictedLikelihood(const Eigen::MatrixXd& series,
                                                                       const AutoregressiveNoise& noise);

/// By how much the noise model raises the restricted log-likelihood of residuals above that of white noise,
/// the variance being profiled out of both (Patterson and Thompson 1971): what the parameters took out of the
/// noise counts. `basis` as above. 0 where it is not defined.
[[nodiscard]] double restrictedGain(std::span<const double> residuals, const Eigen::MatrixXd& basis,
                                    const AutoregressiveNoise& noise);

/// X C X' with C the covariance of the noise, X one row a column of the regression. Stationary noise, or
/// noise that begins with the record, as that from the force channel does: what it did before is in the
/// start. O(N p) by filtering X backwards.
[[nodiscard]] Eigen::MatrixXd spreadUnderNoise(const Eigen::MatrixXd& columns,
                                               const AutoregressiveNoise& noise);

/// d ln(x C x') / d coefficients[i] for every row x of `rows`, a row each, of stationary autoregressive noise
/// whose innovations' variance stays; not finite for a row of zeros.
[[nodiscard]] Eigen::MatrixXd logSpreadSlopes(const Eigen::MatrixXd& rows, const AutoregressiveNoise& noise);

/// e[t] = sum_i coefficients[i-1] e[t-i] + w[t], w white: the model that a series of residuals has of itself.
struct SeriesModel {
    std::vector<double> coefficients; ///< empty: white
    double logLikelihood = 0;         ///< Gaussian: -N/2 (ln(2 pi var w) + 1)
};

/// Yule-Walker by Levinson's recursion, always stationary; the order, 0 to min(20, N / 10), by BIC. For
/// whitening a regression and for comparing models; the errors of m, b and k have a noise model of their own,
/// which counts what the parameters took out. Nothing for a series of zeros or numbers that are not finite.
[[nodiscard]] std::optional<SeriesModel> autoregressiveModel(std::span<const double> series);

} // namespace gripscope
