// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/line_report.h"
#include "devices/line/mqtt/sparkplug_payload.h"

namespace gripscope {

/// What a result is made of as metrics of a device, in an order that never changes: later ones are added at
/// the end. Aliases are `firstAlias` and the numbers behind it. Without a report every value is null.
enum class MetricsFor { Birth, Data };
[[nodiscard]] std::vector<SparkplugMetric> resultMetrics(const LineReport* report, std::uint64_t firstAlias,
                                                         MetricsFor use);
/// More than there are metrics of a result.
inline constexpr std::uint64_t aliasesOfDevice = 32;

} // namespace gripscope
