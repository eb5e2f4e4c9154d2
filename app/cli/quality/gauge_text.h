// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_study.h"

namespace gripscope::cli {

/// Tables of a gauge study and what it says, for a person.
[[nodiscard]] QString gaugeText(const GaugeStudy& study);

} // namespace gripscope::cli
