// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_study.h"

namespace gripscope {

// AIAG's limits of the gauge's share of the study variation or tolerance, and of distinct categories.
inline constexpr double goodGaugePercent = 10, usableGaugePercent = 30, leastDistinctCategories = 5;
/// More combinations of several values than this are told as "more than": nobody sorts into as many, and how
/// many it is beyond that follows from the third digit of a variance.
inline constexpr double mostCombinationsTold = 50;

enum class GaugeGrade { Good, Usable, NotGoodEnough };

/// By the worst of: percent study variation, percent tolerance (where there is one), and fewer than five
/// distinct categories, which is not good enough.
[[nodiscard]] GaugeGrade gaugeGrade(const GaugeValue& value);

/// The verdict, what dominates, whether operators matter, what to do next; then what a person should know of
/// how it was found: pooled, negative, at the boundary, left out, missing.
[[nodiscard]] Findings gaugeMessages(const GaugeValue& value, const GaugeLayout& layout,
                                     const GaugeOptions& options);

[[nodiscard]] Findings jointGaugeMessages(const GaugeStudy& study);

} // namespace gripscope
