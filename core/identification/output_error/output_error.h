// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <vector>

namespace gripscope {

/// What is asked of the residuals.
enum class ResidualDepth {
    Sums,  ///< no noise model; `covariance` is that under white noise. For a fit on the way to another
    Noise, ///< and whether they are white, the noise that they are, and `covariance` under it
    Tests, ///< and what of input, feedback and spring is left in them: of an estimate that is shown or judged
};

/// How to find m, b, k by output error. A lost force is one more unknown, its position is no row of the sum.
struct OutputErrorOptions : ContinuousTimeOptions {
    int maxIterations = 200;
    /// The step still to go, in standard errors, at which the search has arrived.
    double arrived = 1e-9;
    ResidualDepth residuals = ResidualDepth::Tests;
};

/// Minimises sum (y - x(m, b, k, x0, v0, offset, lost forces))^2 over the measured samples, x the exact
/// response of m x'' + b x' + k x = F to the force as it is held. Levenberg-Marquardt in ln m, ln b, ln k
/// with exact sensitivities; x0, v0 and offset, which enter linearly, are solved for at every step. Under
/// white Gaussian position noise and known force this is the maximum-likelihood estimate: it reaches the
/// Cramer-Rao bound, and `covariance` = s^2 (J'J)^-1 is that bound with s^2 = SSE / (N - p), p counting m, b,
/// k and every free nuisance (Ljung, System Identification, ch. 7 and 9). Where the residuals are certainly
/// not white (residual_noise.h) the estimate stays and `covariance` is (J'J)^-1 J'CJ (J'J)^-1 with C from the
/// noise model in `noise`.
///
/// All numbers must be finite, force and position equally long, the sample time positive. Statuses:
/// Converged; NotConverged with the last iterate; TooFewSamples when N <= p; NotIdentifiable with words when
/// the data does not determine m, b and k (constant position, a lone step with everything free, an optimum at
/// zero or infinity).
[[nodiscard]] Estimate estimateOutputError(const std::vector<double>& force,
                                           const std::vector<double>& position,
                                           const OutputErrorOptions& options);

/// The mean of the squared residuals is smaller.
[[nodiscard]] bool explainsMore(const Estimate& estimate, const Estimate& other);

/// For a comparison with `known`, an estimate of the same record under other options: with the noise model of
/// ResidualDepth::Noise where it explains more, else with the sums alone, since what is not white about the
/// residuals of a worse model is what it lacks.
[[nodiscard]] Estimate estimateBeside(const Estimate& known, const std::vector<double>& force,
                                      const std::vector<double>& position, OutputErrorOptions options);

} // namespace gripscope
