// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>

namespace gripscope {

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

} // namespace gripscope
