// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/result/determined_parameters.h"
#include "core/recognition/types/type_model.h"

#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// The parameter of a motion that a quantity is; of the relaxing share k1.
[[nodiscard]] MotionParameter parameterOf(TypeQuantity quantity);

/// What the recommended estimate determines besides m, b and k, or in their place: the logarithms of those of
/// m, b, k, k1/k, tau and Fc that it has and knows to a factor of 1.6 (one standard error; friction to a
/// third, so that it is told from none), with their covariance to first order. The object's alone, in SI
/// where the channels' units are known, as comparableUnit(). Nothing where that is m, b and k and no
/// more, nothing at all, or where no errors are known.
[[nodiscard]] std::optional<DeterminedQuantities> determinedQuantities(const Identification& identification,
                                                                       const QString& forceUnit,
                                                                       const QString& positionUnit);

/// The same as a person is told it, in the units that determinedQuantities() was given: m, b, k, k1, tau and
/// Fc as far as they are there, with intervals of 95 %.
[[nodiscard]] std::vector<DeterminedParameter> determinedParameters(const DeterminedQuantities& determined,
                                                                    const QString& forceUnit,
                                                                    const QString& positionUnit);

/// The squeeze as recognition takes it: m, b and k of the object where they were found, in the same units,
/// and what it determines besides. Nothing where neither is there.
[[nodiscard]] std::optional<TypeSqueeze> identifiedSqueeze(const QString& type,
                                                           const Identification& identification,
                                                           const QString& forceUnit,
                                                           const QString& positionUnit);

} // namespace gripscope
