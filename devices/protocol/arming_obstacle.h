// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/field_problem.h"
#include "devices/protocol/messages.h"

namespace gripscope::protocol {

/// Shorter than 100 ms, a heartbeat that a busy computer sends late trips it; longer than 200 ms, a hand is
/// in the gripper for too long before it does.
inline constexpr std::uint16_t shortestWatchdog_ms = 100;
inline constexpr std::uint16_t longestWatchdog_ms = 200;
/// Rarer reports than this could not tell a stop in time; a report holds one sample at least.
inline constexpr double longestReportPeriod_s = 0.02;

/// Why a gripper whose description could be read must not be armed all the same: the first field outside the
/// range that devices/PROTOCOL.md asks of a gripper that is armed. Listening needs none of them.
[[nodiscard]] std::optional<FieldProblem> armingObstacle(const MeasurementFeature& measurement,
                                                         const LimitsFeature& limits);

[[nodiscard]] QString describeObstacle(const FieldProblem& problem);
/// Its reports come every `period_ms`, where every `longest_ms` is asked for.
[[nodiscard]] QString tooSeldom(double period_ms, double longest_ms);

} // namespace gripscope::protocol
