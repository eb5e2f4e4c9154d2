// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/library/records/study_record.h"

namespace gripscope {

/// m, b, k of a squeeze for a study, in SI where the channels' units are known, with validity and, where it
/// may not be used, why; the outcome says which. A squeeze is used unless it is invalid or does not determine
/// m, b and k; one that is suspect is used and says so.
///
/// The standard uncertainties are what differs from squeeze to squeeze: the budget's lines of type A where it
/// was assessed, else the estimate's noise. What all squeezes of a gripper have in common (calibration, lag)
/// does not scatter between them, and would hide in a comparison with their repeats.
[[nodiscard]] NewStudyMeasurement squeezeMeasured(const Identification& identification,
                                                  const Recording& recording);

} // namespace gripscope
