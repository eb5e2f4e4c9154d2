// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "ui/format/number_format.h"

namespace gripscope {

/// m, b and k of an estimate for the screen, in SI where the channels' units allow it, with the half widths
/// of their 95 % intervals.
struct ParameterTexts {
    FormattedNumber m, b, k;
};
/// With the intervals of the uncertainty budget, which count all that is uncertain; without a budget, those
/// of the recommended estimate's noise.
[[nodiscard]] ParameterTexts parameterTexts(const Identification& identification, const QString& forceUnit,
                                            const QString& positionUnit);
[[nodiscard]] ParameterTexts parameterTexts(const Estimate& estimate, const QString& forceUnit,
                                            const QString& positionUnit);
/// The same from the numbers alone; `standardErrors` may be absent.
[[nodiscard]] ParameterTexts parameterTexts(const MassDampingStiffness& parameters,
                                            const std::optional<Eigen::Vector3d>& standardErrors,
                                            const QString& forceUnit, const QString& positionUnit);
/// The same from half widths that the caller knows.
[[nodiscard]] ParameterTexts parameterTextsWithin(const MassDampingStiffness& parameters,
                                                  const std::optional<Eigen::Vector3d>& halfWidths,
                                                  const QString& forceUnit, const QString& positionUnit);

} // namespace gripscope
