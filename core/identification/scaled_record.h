// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error_problem.h"

namespace gripscope {

/// A record in units of its own; what output error calls its problem serves others that simulate, too.
using ScaledRecord = OutputErrorProblem;

/// x0, v0 and offset in channel units, those that are free.
[[nodiscard]] Nuisance nuisanceInChannelUnits(const ScaledRecord& record, double x0, double v0,
                                              double offset);

/// The sum of squares of the positions.
[[nodiscard]] double squaredSize(const ScaledRecord& record);
/// The same, less their mean where the offset is free.
[[nodiscard]] double positionEnergy(const ScaledRecord& record);

/// Its first samples, at most `most`.
[[nodiscard]] ScaledRecord firstSamples(const ScaledRecord& record, std::size_t most);

[[nodiscard]] bool isConstant(const std::vector<double>& values);

} // namespace gripscope
