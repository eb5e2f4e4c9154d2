// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_limits.h"

#include "core/base/words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

bool allReadings(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), isReading);
}

bool chainInRange(const MeasuringChain& chain)
{
    const std::array numbers{chain.forceLagUncertainty_s, chain.forceNoiseDeviation,
                             chain.forceScaleUncertainty, chain.positionScaleUncertainty,
                             chain.frameCompliance,       chain.frameComplianceUncertainty};
    if (!std::all_of(numbers.begin(), numbers.end(), isReading))
        return false;
    if (chain.friction && !(isReading(chain.friction->value) && isReading(chain.friction->standardError)))
        return false;
    return !chain.baseline ||
           (std::all_of(chain.baseline->parameters.begin(), chain.baseline->parameters.end(), isReading) &&
            std::all_of(chain.baseline->standardErrors.begin(), chain.baseline->standardErrors.end(),
                        isReading));
}

} // namespace

bool isSampleTime(double seconds)
{
    return seconds >= shortestSampleTime_s && seconds <= longestSampleTime_s;
}

bool isReading(double value)
{
    return std::abs(value) <= largestReading;
}

std::size_t samplesIn(double seconds, double sampleTime_s)
{
    const double samples = std::round(seconds / sampleTime_s);
    // Not the other way round: NaN is no number of samples.
    if (!(samples >= 0 && samples <= static_cast<double>(mostSamples)))
        return mostSamples + 1;
    return static_cast<std::size_t>(samples);
}

Finding sampleTimeExpectation()
{
    return Words::say("seconds from %1 to %2").arg(shortestSampleTime_s).arg(longestSampleTime_s);
}

std::optional<Finding> outOfRange(const Recording& recording)
{
    const std::size_t samples = recording.size();
    const auto lengthFits = [samples](std::size_t size) { return size == 0 || size == samples; };
    if (recording.time_s.size() != samples || recording.position.size() != samples ||
        !lengthFits(recording.sequence.size()) || !lengthFits(recording.status.size()))
        return Words::say("its channels differ in length");
    if (samples > mostSamples)
        return Words::say("it has %1 samples, at most %2 can be kept").arg(samples).arg(mostSamples);
    if (recording.provenance.size() > mostFacts)
        return Words::say("more than %1 facts stand beside its samples").arg(mostFacts);
    const bool timeless = samples == 0 && recording.sampleTime_s == 0;
    if (!timeless && !isSampleTime(recording.sampleTime_s))
        return Words::say("its sample time is %1 s and not %2")
            .arg(recording.sampleTime_s)
            .arg(sampleTimeExpectation());
    if (!(std::abs(recording.forceLag_s) <= longestForceLag_s))
        return Words::say("its force lag is %1 s, at most %2 s can be")
            .arg(recording.forceLag_s)
            .arg(longestForceLag_s);
    if (!allReadings(recording.time_s) || !allReadings(recording.force) || !allReadings(recording.position))
        return Words::say("one of its numbers is not finite, or beyond %1").arg(largestReading);
    if (std::adjacent_find(recording.time_s.begin(), recording.time_s.end(), std::greater_equal<>()) !=
        recording.time_s.end())
        return Words::say("its times do not increase");
    if (!chainInRange(recording.chain))
        return Words::say("a number of its measuring chain is not finite, or beyond %1").arg(largestReading);
    return std::nullopt;
}

} // namespace gripscope
