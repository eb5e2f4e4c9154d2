// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/squeeze_notes.h"
#include "core/signal/recording/recording_limits.h"
#include "devices/profile/profile_note.h"
#include "tests/fuzz/fuzzing.h"

// Notes beside the raw reports of a session.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QString note = QString::fromUtf8(bytesOf(data, size));
    if (const auto begins = squeezeBegins(note)) {
        require(begins->samples <= mostSamples);
        const auto again = squeezeBegins(toNote(*begins));
        require(again && again->samples == begins->samples && again->mode == begins->mode);
        SqueezeRecorder recorder;
        recorder.begin(begins->mode, begins->samples, 0.0005);
    }
    if (const auto ended = squeezeEnded(note)) {
        require(ended->samples <= mostSamples && ended->head.size() == 0);
        require(!outOfRange(ended->head));
        const auto again = squeezeEnded(toNote(*ended));
        require(again && again->samples == ended->samples);
    }
    if (const auto device = profiledDeviceOf(note))
        require(profiledDeviceOf(toNote(*device)).has_value());
    return 0;
}
