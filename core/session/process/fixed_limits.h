// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/process/process_options.h"

namespace gripscope {

/// As the library keeps them, JSON; numbers read back to the same bits.
[[nodiscard]] QString toText(const FixedLimits& limits);
/// Nothing for what toText() does not write: another version, numbers that are not finite, a sigma that is
/// not above 0, sizes that do not fit.
[[nodiscard]] std::optional<FixedLimits> fixedLimitsFromText(const QString& text);

} // namespace gripscope
