// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimators/run_estimator.h"
#include "core/identification/result/identification_result.h"

namespace gripscope {

/// The budget of the estimate that an identification recommends: its noise, the counts, the chain's effects,
/// the other hold as far as that is probable, and what windows of the record disagree by. Of a motion without
/// all of m, b and k the lines are in `further` (MotionDoubts): its other form is a carriage with friction of
/// its own each way, or, where the mass was left out, the motion that has one. Without parameters and
/// covariance: a budget that says why there is none. `holdIsDeclared`: nobody had to assume it.
[[nodiscard]] UncertaintyBudget squeezeBudget(const Identification& data, const PreparedRecord& record,
                                              const EstimatorTask& task, bool holdIsDeclared);

} // namespace gripscope
