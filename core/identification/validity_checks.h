// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

namespace gripscope {

/// Every check of the contract, in its order, on an identification whose estimates and recommendation are
/// filled in.
[[nodiscard]] std::vector<ValidityCheck> checkValidity(const Identification& identification,
                                                       const Recording& recording,
                                                       const IdentificationOptions& options);

} // namespace gripscope
