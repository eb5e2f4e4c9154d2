// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/inspection_record.h"
#include "core/library/records/yield.h"

#include <QString>

namespace gripscope {

/// The share, with the exact bounds (Clopper and Pearson) that hold the rate with 95 % confidence: "97.8 % as
/// expected (96.0 to 98.9 %)". Empty where nothing was judged. The same wherever a yield is told.
/// Where nothing was expected, nothing is said to be as expected.
[[nodiscard]] QString yieldText(const Yield& yield);
[[nodiscard]] QString yieldText(const InspectionCounts& counts);
/// What is behind "3 of 4": "3 of 4 were as expected".
[[nodiscard]] QString yieldCounted(const InspectionCounts& counts);
/// What the numbers mean, in a sentence or two.
[[nodiscard]] QString yieldExplained(const Yield& yield);
[[nodiscard]] QString yieldExplained(const InspectionCounts& counts);

} // namespace gripscope
