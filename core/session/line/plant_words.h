// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/link/plant_status.h"
#include "core/session/line/line_status.h"

namespace gripscope {

/// "plant: in step", "plant: 3120 results waiting, server not reached since 10:42".
[[nodiscard]] LineWords plantWords(const PlantStatus& status, const QDateTime& now);

} // namespace gripscope
