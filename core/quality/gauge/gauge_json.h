// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_study.h"

#include <QJsonObject>

namespace gripscope {

/// The document of `study gauge`. A component whose variance was estimated below 0 says so and holds
/// "taken_as": 0, which its shares and all sums are of; an upper bound of null: there is none.
[[nodiscard]] QJsonObject gaugeJson(const GaugeStudy& study);

} // namespace gripscope
