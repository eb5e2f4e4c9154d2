// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/recognition/types/quantity_space.h"

namespace gripscope {

/// "mass", "relaxation time": within a sentence.
[[nodiscard]] Finding nameWithin(TypeQuantity quantity);

} // namespace gripscope
