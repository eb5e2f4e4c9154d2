// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"

namespace gripscope {

class Settings;

/// In which units the person wants to read.
[[nodiscard]] DisplayUnits chosenUnits(const Settings& settings);

} // namespace gripscope
