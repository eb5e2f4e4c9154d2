// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

namespace gripscope {

/// "Mass", "Damping" or "Stiffness", for the beginning of a sentence.
[[nodiscard]] Finding nameOf(MechanicalQuantity quantity);

/// Three significant digits without exponent where it is readable: "9.98", "12", "0.0396".
[[nodiscard]] Finding shortNumber(double value);

} // namespace gripscope
