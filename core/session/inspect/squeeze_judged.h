// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/early/early_stop.h"
#include "core/recognition/types/type_shift.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/inspect/judging_policy.h"

#include <optional>

namespace gripscope {

/// What a squeeze of an inspection was judged by, as a note behind it (squeezeJudgedNote): whoever replays it
/// comes to the same verdict.
struct SqueezeJudged {
    VerdictOptions rates;                     ///< units and range are the recording's
    std::optional<EarlyEnd> earlyEnd = {};    ///< what ended it before its time
    JudgingPolicy policy = {};                ///< what was refused then
    std::optional<CommonShift> transfer = {}; ///< that it was adjusted by; absent: it was not
};
[[nodiscard]] QString toNote(const SqueezeJudged& judged);
/// Nothing for a note of another kind, or one that is damaged.
[[nodiscard]] std::optional<SqueezeJudged> squeezeJudged(const QString& note);

} // namespace gripscope
