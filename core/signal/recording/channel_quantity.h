// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

namespace gripscope {

/// A number of a channel, a force or a length by `quantity`, as its reader wants it where the channel's unit
/// is one that is known (units.h); else with the channel's own unit, and bare where that is "1".
[[nodiscard]] Finding channelQuantity(MechanicalQuantity quantity, double value, const QString& unit);

} // namespace gripscope
