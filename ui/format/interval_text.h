// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/uncertainty/uncertainty_budget.h"

#include <QString>

namespace gripscope {

/// A value with its interval, for the screen: "9.98 ± 0.05 kN/m" where the interval is symmetric to a tenth
/// of its half width, "9.98 kN/m (9.5 to 10.8)" where it is not, "at most 3.1 g" where the data gives no
/// more.
[[nodiscard]] QString intervalText(double value, const CoverageInterval& interval, const QString& unit);

} // namespace gripscope
