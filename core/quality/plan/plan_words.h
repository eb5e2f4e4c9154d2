// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/plan/study_progress.h"

namespace gripscope {

/// What is to be done for that row: who puts in which part, by its label alone. Nothing of earlier results.
[[nodiscard]] Finding instruction(const StudyPlan& plan, std::size_t row);
/// "Squeeze 14 of 90. 1 was left out."
[[nodiscard]] Finding progressWords(const StudyProgress& progress);

} // namespace gripscope
