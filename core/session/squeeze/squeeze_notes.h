// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/squeeze/squeeze_recorder.h"
#include "core/signal/recording/recording.h"

#include <optional>
#include <string_view>

namespace gripscope {

/// How the notes begin that a squeeze leaves beside the raw reports (GripperPort::note), so that it can be
/// cut out of them again as it was.
inline constexpr std::string_view squeezeBeginsNote = "squeeze begins\n";
inline constexpr std::string_view squeezeEndedNote = "squeeze ended\n";
/// What the squeeze before it was judged by (core/session/inspect/squeeze_judged.h).
inline constexpr std::string_view squeezeJudgedNote = "squeeze judged\n";

struct SqueezeBegins {
    SqueezeRecorder::Mode mode = SqueezeRecorder::Mode::Movement;
    std::size_t samples = 0;
    std::optional<std::uint64_t> after; ///< the sample that was drained last; the squeeze has later ones
};
struct SqueezeEnded {
    std::optional<QString> failure; ///< in words; none: it became a recording
    std::size_t samples = 0;        ///< in the recording
    Recording head;                 ///< the recording but for its samples
};

[[nodiscard]] QString toNote(const SqueezeBegins& begins);
[[nodiscard]] QString toNote(const SqueezeEnded& ended);
/// Nothing for a note of another kind, or one that is damaged.
[[nodiscard]] std::optional<SqueezeBegins> squeezeBegins(const QString& note);
[[nodiscard]] std::optional<SqueezeEnded> squeezeEnded(const QString& note);

} // namespace gripscope
