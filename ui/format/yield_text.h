// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"

#include <QString>

namespace gripscope {

/// Of the parts that were judged, how many were as expected, with the exact bounds (Clopper and Pearson) that
/// hold the rate with 95 % confidence: "97.8 % as expected (96.0 to 98.9 %)". Squeezes that called for
/// another one, not valid or inconclusive, judged nothing. Empty where nothing was judged.
[[nodiscard]] QString yieldText(const InspectionCounts& counts);
/// What the numbers mean, in a sentence or two.
[[nodiscard]] QString yieldExplained(const InspectionCounts& counts);

} // namespace gripscope
