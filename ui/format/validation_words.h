// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/periodic/periodic.h"
#include "core/identification/validation/validation.h"
#include "ui/format/fact.h"

#include <QString>

#include <vector>

namespace gripscope {

/// What a validation found, line by line: on what, both fits by name with the one to be expected, the tests,
/// how far m, b and k are off. Empty when there was nothing to simulate.
[[nodiscard]] std::vector<Fact> validationFacts(const Validation& validation);

/// What the periods of the force tell, in one sentence: whether the force answers to the position, whether
/// the spring is straight, whether the misfit is larger than the noise.
[[nodiscard]] QString periodSentence(const PeriodicDiagnostics& periods);
/// The same in numbers.
[[nodiscard]] std::vector<Fact> periodFacts(const PeriodicDiagnostics& periods, const QString& forceUnit,
                                            const QString& positionUnit);

} // namespace gripscope
