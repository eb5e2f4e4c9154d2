// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

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

} // namespace gripscope
