// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>

namespace gripscope {

// Variances under a noise model are uncertain themselves, as the model is estimated: standard errors are
// multiplied so that they give 95 % intervals with the normal quantile.

/// The factor for one parameter: Student's t with f degrees of freedom, at least 3, over the normal quantile.
/// Var(ln variance) = `logVarianceSpread` of a chi-square is about 2 / f (Satterthwaite 1946). At least 1.
[[nodiscard]] double errorExpansion(double logVarianceSpread);

/// ln variances of the parameters of interest under the noise. `basis`: orthonormal rows that span the
/// sensitivities; `gains`: a row for each, how the parameters come from the basis' coordinates.
[[nodiscard]] Eigen::VectorXd logVariances(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& gains,
                                           const AutoregressiveNoise& noise);

/// The factors for an autoregressive model fitted to as many residuals as the basis has columns: its
/// coefficients scatter by variance Gamma^-1 / N (Box and Jenkins, section 7.2), Gamma their
/// autocovariances, and ln variance by 2 / N. 400 residuals with a correlation of 0.8: about 1.06 for the
/// stiffness, whose variance is that of the lowest frequencies. 1 with more than 20,000 residuals.
[[nodiscard]] Eigen::VectorXd autoregressiveExpansion(const Eigen::MatrixXd& basis,
                                                      const Eigen::MatrixXd& gains,
                                                      const AutoregressiveNoise& noise);

/// How one sample of force moves the position of a mass, spring and damper, as a difference equation:
/// x[t] = -a[1] x[t-1] - a[2] x[t-2] + b[0] f[t] + b[1] f[t-1] + b[2] f[t-2], a[0] = 1.
struct ForceResponse {
    std::array<double, 3> a{1, 0, 0}, b{0, 0, 0};
};
/// Exact for the hold; a lag shifts noise in time and leaves its spectrum alone.
[[nodiscard]] ForceResponse forceResponse(const MassDampingStiffness& parameters, double sampleTime_s,
                                          ForceHold hold);

/// White noise in the measured force besides white noise in the position: the object never felt the former,
/// the model did, so that the residual is e = w - G n, an ARMA(2, 2) process whose autoregressive part is the
/// object's own and whose one free number is the ratio of the two variances. A general autoregression needs
/// an order of ten and more for the same spectrum and misses its lowest frequencies, where k is found
/// (coverage of k 72 % against 94 %, 400 samples, 10 % force noise).
struct ForceNoiseFit {
    AutoregressiveNoise noise; ///< with forceDeviation, in the units of the arguments
    double gain = 0;           ///< of the restricted log-likelihood over white noise, at least 0
    /// Variances of the three parameters of interest under this noise are uncertain too; the standard errors
    /// times these give 95 % intervals with the normal quantile (Student's t with the degrees of freedom of
    /// the variance, after Satterthwaite 1946).
    Eigen::Vector3d expansion = Eigen::Vector3d::Ones();
};

/// Restricted maximum likelihood (Patterson and Thompson 1971), which counts what the parameters took out of
/// the noise. `basis`: an orthonormal basis of the sensitivities, a row a parameter; `gains`: three rows, how
/// the parameters of interest come from the basis' coordinates. Nothing when the response is not usable.
[[nodiscard]] std::optional<ForceNoiseFit> fitForceNoise(std::span<const double> residuals,
                                                         const Eigen::MatrixXd& basis,
                                                         const Eigen::MatrixXd& gains,
                                                         const ForceResponse& response);

/// Made symmetric; nothing unless it is finite and its variances are above zero.
[[nodiscard]] std::optional<Eigen::MatrixXd> usableCovariance(const Eigen::MatrixXd& covariance);

/// Noise that was found in the residuals of least squares and what it makes of the errors.
struct ResidualNoise {
    AutoregressiveNoise noise;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of the three parameters of interest
    int fittedNumbers = 0; ///< the noise model's own, for the tests that follow
};

/// Which noise the residuals hold: white, autoregressive, or white noise of the force channel besides that of
/// the position; the last two by the Bayesian criterion on restricted likelihoods. Nothing: white, and the
/// usual s^2 (J'J)^-1 holds. A noise model is taken only when Ljung-Box gives `whitenessP` below 0.001 or
/// when the likelihood ratio for noise of the force (one variance, on the edge of its range: half a
/// chi-square with one degree of freedom) has a p-value below 0.0025.
///
/// `basis`: orthonormal rows that span the sensitivities; `gains`: three rows, how the parameters of interest
/// come from the basis' coordinates.
[[nodiscard]] std::optional<ResidualNoise> findResidualNoise(std::span<const double> residuals,
                                                             const Eigen::MatrixXd& basis,
                                                             const Eigen::MatrixXd& gains,
                                                             const ForceResponse& response,
                                                             std::optional<double> whitenessP);

} // namespace gripscope
