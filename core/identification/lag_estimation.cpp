// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/lag_estimation.h"

#include "core/identification/lag_profile.h"
#include "core/identification/pooled_mean.h"
#include "core/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Log-likelihood by which two readings of a record must differ to be told apart.
constexpr double clearGain = 10;
constexpr double smallestSearch = 0.5, largestSearch = 20;

LagEstimate failed(LagStatus status, const QString& message)
{
    LagEstimate estimate;
    estimate.status = status;
    estimate.message = message;
    return estimate;
}

double expectedGain(double sampleTime_s, double standardError_s)
{
    constexpr double most = 1e12; // a record without noise tells everything
    const double half = sampleTime_s / 2;
    const double gain = standardError_s > 0 ? half * half / (2 * standardError_s * standardError_s) : most;
    return std::min(gain, most);
}

QString microseconds(double seconds)
{
    return Words::number(seconds * 1e6, 'g', 4);
}

/// Status and words for a lag with an error.
void judge(LagEstimate& estimate)
{
    estimate.expectedGain = expectedGain(estimate.sampleTime_s, estimate.standardError_s);
    const QString value = Words::tr("%1 us, known to %2 us")
                              .arg(microseconds(estimate.lag_s), microseconds(estimate.standardError_s));
    if (estimate.holdGain && *estimate.holdGain < clearGain) {
        estimate.status = LagStatus::HoldOrLag;
        estimate.message =
            Words::tr("a lag of %1; but the other force hold with another lag does as well. Name the hold.")
                .arg(value);
    } else if (estimate.expectedGain < clearGain) {
        estimate.status = LagStatus::TooUncertain;
        estimate.message =
            Words::tr("a lag of %1: too little to tell it from none. Measure it on more squeezes, or on a "
                      "stiffer object with less noise.")
                .arg(value);
    } else {
        estimate.status = LagStatus::Measured;
        estimate.message =
            Words::tr("the position channel samples later than the force channel by %1").arg(value);
    }
}

bool isUsable(const std::vector<double>& force, const std::vector<double>& position,
              const LagEstimationOptions& options)
{
    const auto finite = [](double value) { return std::isfinite(value); };
    return force.size() == position.size() && std::isfinite(options.sampleTime_s) &&
           options.sampleTime_s > 0 && std::isfinite(options.expectedLag_s / options.sampleTime_s) &&
           std::isfinite(options.searchedSamples) && std::all_of(force.begin(), force.end(), finite) &&
           std::all_of(position.begin(), position.end(), finite);
}

/// ln of the likelihood ratio of the best lags under the two holds.
std::optional<double> gainOverOtherHold(const LagProfile& profile, const LagMinimum& best)
{
    const std::optional<LagMinimum> other = profile.withOtherHold().minimum();
    if (!other || !(best.sse > 0))
        return std::nullopt;
    return best.degreesOfFreedom / 2 * std::log(other->sse / best.sse);
}

} // namespace

LagEstimate estimateLag(const std::vector<double>& force, const std::vector<double>& position,
                        const LagEstimationOptions& options)
{
    if (!isUsable(force, position, options))
        return failed(LagStatus::NotEstimated,
                      Words::tr("the data or the options hold numbers that can't be used"));
    LagRange range;
    range.middle = options.expectedLag_s / options.sampleTime_s;
    range.half = std::clamp(options.searchedSamples, smallestSearch, largestSearch);
    const LagProfile profile(force, position, options, range);
    const std::optional<LagMinimum> best = profile.minimum();
    if (!best)
        return failed(
            LagStatus::NotEstimated,
            Words::tr("no m, b and k could be found, so there is nothing to measure the lag against"));
    LagEstimate estimate;
    estimate.sampleTime_s = options.sampleTime_s;
    estimate.lag_s = best->lag * options.sampleTime_s;
    if (best->atEnd || !best->error) {
        estimate.status = LagStatus::AtLimit;
        estimate.message =
            Words::tr("the best lag, %1 us, lies at the end of what was searched: the object is no mass, "
                      "spring and damper at this force, or the lag is much larger than expected")
                .arg(microseconds(estimate.lag_s));
        return estimate;
    }
    estimate.standardError_s = *best->error * options.sampleTime_s;
    if (!options.holdIsKnown)
        estimate.holdGain = gainOverOtherHold(profile, *best);
    judge(estimate);
    return estimate;
}

LagEstimate combineLags(std::span<const LagEstimate> squeezes)
{
    std::vector<LagEstimate> used;
    for (const LagEstimate& squeeze : squeezes) {
        if (squeeze.hasValue() && std::isfinite(squeeze.lag_s) && squeeze.standardError_s >= 0)
            used.push_back(squeeze);
    }
    if (used.empty())
        return failed(LagStatus::NotEstimated, Words::tr("none of the squeezes tells the lag"));
    LagEstimate combined;
    combined.squeezes = 0;
    std::vector<ValueWithError> lags;
    for (const LagEstimate& squeeze : used) {
        // No squeeze is perfect: a floor keeps one without noise from outweighing all others without end.
        lags.push_back({squeeze.lag_s, std::max(squeeze.standardError_s, 1e-9 * squeeze.sampleTime_s)});
        combined.squeezes += squeeze.squeezes;
        combined.sampleTime_s = std::max(combined.sampleTime_s, squeeze.sampleTime_s);
    }
    const ValueWithError mean = pooledMean(lags);
    combined.lag_s = mean.value;
    combined.standardError_s = mean.standardError;
    judge(combined);
    return combined;
}

} // namespace gripscope
