// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sound/outcome_tones.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {
constexpr double loudness = 0.35; ///< of full scale: heard beside a machine, not felt
constexpr double fade_s = 0.006;
} // namespace

Sound soundOf(InspectionOutcome outcome)
{
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return Sound::AsExpected;
    case InspectionOutcome::OtherType:
        return Sound::OtherType;
    case InspectionOutcome::Unknown:
        return Sound::Unknown;
    case InspectionOutcome::Inconclusive:
        return Sound::Inconclusive;
    case InspectionOutcome::NotValid:
        break;
    }
    return Sound::NotValid;
}

std::vector<Tone> tonesOf(Sound sound)
{
    switch (sound) {
    case Sound::AsExpected:
        return {{1320, 0.09}};
    case Sound::OtherType:
        return {{880, 0.12}, {0, 0.03}, {587, 0.18}};
    case Sound::Unknown:
        return {{880, 0.09}, {0, 0.04}, {880, 0.09}, {0, 0.04}, {880, 0.09}};
    case Sound::Inconclusive:
        return {{740, 0.1}, {0, 0.05}, {740, 0.1}};
    case Sound::NotValid:
        return {{294, 0.4}};
    case Sound::BatchWhole:
        return {{784, 0.1}, {988, 0.1}, {1319, 0.2}};
    case Sound::CodeUnknown:
        return {{392, 0.1}, {0, 0.05}, {294, 0.15}};
    }
    return {};
}

QByteArray samplesOf(const std::vector<Tone>& tones)
{
    std::vector<std::int16_t> samples;
    for (const Tone& tone : tones) {
        const auto count = static_cast<std::size_t>(std::llround(tone.seconds * soundRate_Hz));
        for (std::size_t i = 0; i < count; ++i) {
            const double at_s = static_cast<double>(i) / soundRate_Hz;
            const double left_s = tone.seconds - at_s;
            const double envelope = std::clamp(std::min(at_s, left_s) / fade_s, 0.0, 1.0);
            const double value = std::sin(2 * std::numbers::pi * tone.frequency_Hz * at_s);
            samples.push_back(static_cast<std::int16_t>(std::lround(loudness * envelope * value * 32767)));
        }
    }
    return {reinterpret_cast<const char*>(samples.data()),
            static_cast<qsizetype>(samples.size() * sizeof(std::int16_t))};
}

} // namespace gripscope
