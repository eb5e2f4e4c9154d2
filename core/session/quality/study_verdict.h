// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_study.h"

namespace gripscope {

/// What a gauge study comes to, in plain sentences: how many kinds of each quantity the gripper tells apart,
/// the most telling first; how many combinations by all of them together; whether operators are the trouble.
/// They are where their share of the gauge's variance is seen (p < 0.05 of the effect or its interaction) in
/// a quantity. The numbers behind it are in the study's own messages.
[[nodiscard]] Findings studyVerdict(const GaugeStudy& study);

} // namespace gripscope
