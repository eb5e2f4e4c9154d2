// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

namespace gripscope {

/// The budget of the recommended estimate, or null when it has no parameters.
[[nodiscard]] inline const UncertaintyBudget* shownBudget(const Identification& identification)
{
    return identification.budget.parameters ? &identification.budget : nullptr;
}

} // namespace gripscope
