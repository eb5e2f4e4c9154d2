// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <vector>

namespace gripscope {

/// A search that only compares, or looks at a part of a record, goes no further: a thousandth of a standard
/// error moves the likelihood by a millionth.
inline constexpr double nearEnough = 1e-3;

struct MotionOptions : ContinuousTimeOptions {
    MotionTerms terms;
    Estimator estimator = Estimator::Friction; ///< the name the estimate gets
    int maxIterations = 40;
    double arrived = 1e-6;   ///< the step still to go, in standard errors, at which the search ends
    Nuisance startNuisance;  ///< that belongs to `start`, as the next
    MotionValues startTerms; ///< of the further terms; all zero: some are tried
    /// The start is the answer for nearly the same motion, of which this is another stretch: the search
    /// begins there, and elsewhere only where that does not settle.
    bool startIsNear = false;
    /// What is known of the friction beforehand, in the force's unit. Given up where the record refutes it:
    /// the part may have friction of its own.
    std::optional<GripperFriction> knownFriction;
};

/// Minimises sum (y - x - offset)^2, x the motion of the family of MotionTerms under the force as it is held,
/// integrated to 1e-12 of itself with sticking exact (MotionIntegrator). Levenberg-Marquardt over all
/// unknowns with the exact derivatives of the integrated motion, from starts that the equation itself and the
/// linear motion give. Under white Gaussian position noise and known force this is the maximum-likelihood
/// estimate.
///
/// `motion->covariance` = s^2 (J'J)^-1, s^2 = SSE / (N - p), p counting the parameters and every unknown of
/// the start: x0 and v0 (with a free initial state), x0 - q0 with a dashpot, the offset; without a spring the
/// start is the offset. With friction the part begins at rest unless that is refuted (p < 0.001): within the
/// friction its speed moves nothing. Where the residuals are certainly not white the autoregressive noise
/// that they hold is counted instead. Friction is not below zero: where the data would have it there, it is
/// zero, its variance stays (so that the others carry what friction might still do), and
/// `motion->frictionLimit` tells how large it may be. Friction that is known beforehand counts as one more
/// measurement of it (the estimate is then the most probable one, its covariance that of both together).
///
/// All numbers must be finite, force and position equally long, the sample time positive. Statuses:
/// Converged; NotConverged with the last iterate; TooFewSamples when N <= p; NotIdentifiable with words when
/// the data does not determine the parameters. 2,000 samples: some 10 ms; with friction some 20 ms.
///
/// Without mass, a damping that the record does not tell (the search ends at none or nowhere, or its standard
/// error is above half of it) is left out as well: the spring alone, y = F / k + offset.
///
/// Where samples were lost their forces are those that output error finds, at first by m, b and k alone, then
/// in positions without what the further terms add (motion_search.h); their rows are skipped, and the errors
/// grow as those of output error do.
[[nodiscard]] Estimate estimateMotion(const std::vector<double>& force, const std::vector<double>& position,
                                      const MotionOptions& options);

/// By how much the terms would raise twice the logarithm of the likelihood above that of a motion with fewer,
/// `base`, to first order (a score test): what one step from there would gain, with some times tau for a
/// dashpot that is new. `options.start` and `startTerms`: where `base` has its optimum. A fraction of the
/// search that it may save; 0 where nothing can be said.
[[nodiscard]] double expectedGain(const std::vector<double>& force, const std::vector<double>& position,
                                  const MotionOptions& options, const MotionTerms& base = {});

} // namespace gripscope
