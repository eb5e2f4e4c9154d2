// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// How the channels were sampled that a model's response is to be compared with.
struct ResponseSampling {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::First;
    double lag_s = 0; ///< how much later the position channel samples than the force channel
};

/// The response of m x'' + b x' + k x = F at one frequency.
struct ModelLine {
    double frequency_Hz = 0;
    std::complex<double> response; ///< position over force, the channels' units
    double phase = 0;              ///< of `response`, radians, without jumps from one frequency to the next
    /// Standard errors to first order: of the magnitude as a share of it, of the phase in radians. Zero
    /// without a covariance.
    double relativeError = 0, phaseError = 0;
};

/// The exact transfer function from force samples to position samples (periodic_response.h) with the lag
/// between the channels, so that it answers the question of empiricalResponse(): hold and folding are in it.
/// With theta = (ln m, ln b, ln k), whose covariance is that of (m, b, k) divided by them,
///     d ln|G| = Re(G^-1 dG/dtheta),   d arg G = Im(G^-1 dG/dtheta)
/// give the errors. A 95 % band is |G| exp(+-1.96 relativeError), phase +- 1.96 phaseError, frequency by
/// frequency.
///
/// Parameters above zero, frequencies ascending, above zero and below half the sample rate. Empty when the
/// parameters leave the range of numbers. Linear in the frequencies.
[[nodiscard]] std::vector<ModelLine> modelResponse(const MassDampingStiffness& parameters,
                                                   const std::optional<Eigen::Matrix3d>& covariance,
                                                   const ResponseSampling& sampling,
                                                   std::span<const double> frequencies_Hz);

/// `count` frequencies from `low_Hz` to `high_Hz`, both above zero, evenly on a logarithmic axis.
[[nodiscard]] std::vector<double> logarithmicFrequencies(double low_Hz, double high_Hz, std::size_t count);

} // namespace gripscope
