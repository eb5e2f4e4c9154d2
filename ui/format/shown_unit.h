// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"

namespace gripscope {

/// The unit in which a column or an axis of m, b or k is shown, all its numbers alike. SI is replaced by what
/// the person reads (core/base/display_units.h); of that kg becomes g, N/m becomes kN/m where it keeps the
/// numbers short; "1" (units as printed) is shown as none; others stay as they are, with a power of a
/// thousand in front where their numbers would run to many noughts. `largest`: the largest magnitude in the
/// column, in `unit`.
[[nodiscard]] ShownUnit shownUnit(const QString& unit, double largest);

/// What is read in place of an SI unit or of a channel's (mN, µm, ...), without regard to the size of the
/// numbers; the unit itself where nothing else was chosen.
[[nodiscard]] ShownUnit readUnit(const QString& unit);

/// Of a cubic spring's k3, whose unit is N/m³ or one as printed: a can's, or the error of one that has none,
/// runs to billions of newtons a cubic metre, so that N/mm³ reads better.
[[nodiscard]] ShownUnit cubicShownUnit(const QString& unit, double largest);

/// "12.5 N" and "3 mm", from SI, in what the person reads.
[[nodiscard]] QString forceText(double force_N);
[[nodiscard]] QString lengthText(double length_m);
/// A force that goes up and down about a preload: "20 ± 10 N".
[[nodiscard]] QString pushText(double bias_N, double peak_N);

} // namespace gripscope
