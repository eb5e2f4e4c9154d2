// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "ui/widgets/number_format.h"

namespace gripscope {

/// m, b and k of an estimate for the screen, in SI where the channels' units allow it, with the half widths
/// of their 95 % intervals.
struct ParameterTexts {
    FormattedNumber m, b, k;
};
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
