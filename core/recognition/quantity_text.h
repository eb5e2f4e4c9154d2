// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

enum class MechanicalQuantity { Mass, Damping, Stiffness };

/// "Mass", "Damping", "Stiffness" for the beginning of a sentence.
[[nodiscard]] QString nameOf(MechanicalQuantity quantity);

/// A value in SI with three significant digits and an SI prefix: 0.0396 -> "39.6 g", 9990 -> "9.99 kN/m".
[[nodiscard]] QString quantityText(MechanicalQuantity quantity, double siValue);

/// Three significant digits without exponent where it is readable: "9.98", "12", "0.0396".
[[nodiscard]] QString shortNumber(double value);

} // namespace gripscope
