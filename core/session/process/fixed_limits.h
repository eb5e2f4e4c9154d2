// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/process_values.h"
#include "core/session/process/process_options.h"

#include <optional>

namespace gripscope {

/// As the library keeps them, JSON; numbers read back to the same bits.
[[nodiscard]] QString toText(const FixedLimits& limits);
/// Nothing for what toText() does not write: another version, numbers that are not finite, a sigma that is
/// not above 0, sizes that do not fit.
[[nodiscard]] std::optional<FixedLimits> fixedLimitsFromText(const QString& text);
/// The same of a record; where it names inspections of another station's library their numbers are 0.
[[nodiscard]] std::optional<FixedLimits> fixedLimitsOf(const std::optional<ProcessLimitsRecord>& record);

} // namespace gripscope
