// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimators/run_estimator.h"
#include "core/identification/result/identification_result.h"

namespace gripscope {

/// The same motion without its mass: `static` for `oe`, `static+zener` for `zener`, `static+duffing` for
/// `duffing`; nothing for the others.
[[nodiscard]] std::optional<Estimator> withoutMass(Estimator estimator);

/// Where the record does not tell the mass of the motion that is recommended (of output error, where that
/// ends at no mass), the motion without it is recommended: what the sample time is too long for is not made
/// up. Not told is a mass
/// - that the search took to zero, or that the force does not determine though its levels tell stiffness from
///   friction;
/// - whose leaving out costs the likelihood less than decisiveDelta and ln N for each unknown less (BIC under
///   white noise), unless its standard error is below a fiftieth of it.
/// Nothing changes where the motion without a mass finds nothing. Run where it was not asked for.
void leaveOutUntoldMass(Identification& data, const PreparedRecord& record, const EstimatorTask& task);

} // namespace gripscope
