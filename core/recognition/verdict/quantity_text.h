// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/recognition/types/quantity_space.h"

namespace gripscope {

/// "Mass", "Relaxation time", for the beginning of a sentence.
[[nodiscard]] Finding nameOf(TypeQuantity quantity);

/// "9.98 kN/m", "0.12 s", "0.3" of a value in SI.
[[nodiscard]] Finding valueOf(TypeQuantity quantity, double si);

/// "stiffness, relaxing share and relaxation time", within a sentence.
[[nodiscard]] Finding listed(const QuantitySpace& space);

/// Three significant digits without exponent where it is readable: "9.98", "12", "0.0396".
[[nodiscard]] Finding shortNumber(double value);

} // namespace gripscope
