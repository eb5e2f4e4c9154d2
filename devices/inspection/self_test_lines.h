// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/inspection/self_test.h"

namespace gripscope {

/// What two seconds of listening gave.
struct SelfTestEvidence {
    GripperIdentity identity;
    LinkCounters before, after; ///< at the beginning and the end of it
    std::vector<Sample> samples;
    std::optional<double> stopAnswered_s; ///< nothing: no answer came
};

// Each a line with figure, limit and advice; pure functions.
[[nodiscard]] SelfTestLine featuresLine(const GripperIdentity& identity, const std::optional<Error>& error);
[[nodiscard]] SelfTestLine rateLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine sequenceLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine clockLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine statusLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine forceNoiseLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine positionNoiseLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine stopLine(const SelfTestEvidence& evidence);

} // namespace gripscope
