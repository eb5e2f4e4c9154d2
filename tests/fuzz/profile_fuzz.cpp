// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_limits.h"
#include "devices/profile/profile_codec.h"
#include "devices/profile/profile_json.h"
#include "tests/fuzz/fuzzing.h"

// Profiles: the document up to the first zero byte is read; the rest are reports for whoever it describes.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray all = bytesOf(data, size);
    const qsizetype zero = all.indexOf('\0');
    const QByteArray json = zero < 0 ? all : all.left(zero);
    const ProfileReading reading = readProfile(json);
    require(reading.profile.has_value() == reading.problems.empty());
    for (const ProfileProblem& problem : reading.problems)
        require(toError(problem, QStringLiteral("x")).describe().size() < 4000);
    if (!reading.profile)
        return 0;
    const GripperProfile& profile = *reading.profile;
    require(isSampleTime(profile.sampleTime_s()));
    const ProfileReading again = readProfile(writeProfile(profile));
    require(again.profile.has_value());
    ProfileDecoder decoder(profile);
    std::vector<Sample> samples;
    const std::size_t length = profile.reportLength;
    for (std::size_t at = static_cast<std::size_t>(json.size()) + 1; at < size; at += length)
        static_cast<void>(decoder.take({data + at, std::min(length, size - at)}, samples));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        require(isReading(samples[i].force) && isReading(samples[i].position) &&
                isReading(samples[i].time_s));
        require(i == 0 || samples[i].sequence > samples[i - 1].sequence);
    }
    return 0;
}
