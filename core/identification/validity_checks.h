// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

namespace gripscope {

/// Every check of the contract, in its order, and after them `linearity` and `feedback`, on an identification
/// whose estimates and recommendation are filled in.
///
/// The checks are a family. Residual whiteness (of the innovations where a noise model was found), input
/// independence, linearity and feedback are tests with p-values and share one false-alarm rate of 1 % (Sidak
/// 1967); the hold adds 0.5 % at the most, and 1.2 % once in all the squeezes
/// whose evidence is summed. A test that finds something counts only when that is worth more
/// than the interval of m, b or k. The others are limits on what was measured.
[[nodiscard]] std::vector<ValidityCheck> checkValidity(const Identification& identification,
                                                       const Recording& recording,
                                                       const IdentificationOptions& options);

} // namespace gripscope
