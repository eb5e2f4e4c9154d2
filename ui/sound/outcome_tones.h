// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"

#include <QByteArray>

#include <vector>

namespace gripscope {

/// What the program lets be heard: a verdict, a batch that is whole, a code that no type has.
enum class Sound { AsExpected, OtherType, Unknown, Inconclusive, NotValid, BatchWhole, CodeUnknown };
[[nodiscard]] Sound soundOf(InspectionOutcome outcome);

/// One after another; frequency 0 is a rest.
struct Tone {
    double frequency_Hz = 0;
    double seconds = 0;
};
/// Told apart by their number and direction, not by pitch alone: one short high tone is as expected, whatever
/// is not has two or more; a measurement that is not valid is one long low tone. None is over half a second.
[[nodiscard]] std::vector<Tone> tonesOf(Sound sound);

inline constexpr int soundRate_Hz = 48000;
/// Signed 16-bit samples of one channel at soundRate_Hz; each tone is faded in and out, so that none clicks.
[[nodiscard]] QByteArray samplesOf(const std::vector<Tone>& tones);

} // namespace gripscope
