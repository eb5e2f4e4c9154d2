// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// The unit in which a column or an axis of m, b or k is shown, all its numbers alike: kg as g, N/m as kN/m
/// where that keeps them short; "1" (units as printed) as none; others as they are, with a power of a
/// thousand in front where their numbers would run to many noughts.
struct ShownUnit {
    QString unit;
    double factor = 1; ///< shown number = number * factor
};
/// `largest`: the largest magnitude in the column.
[[nodiscard]] ShownUnit shownUnit(const QString& unit, double largest);

} // namespace gripscope
