// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/percentile_capability.h"

#include "core/base/random_stream.h"
#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/math/sorted_values.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

constexpr std::array<double, 3> percentileShares{0.00135, 0.5, 0.99865};
constexpr std::size_t fewestForPercentiles = 8, enoughForPercentiles = 1000;
constexpr int fewestResamples = 200, mostResamples = 1'000'000;

/// The percentile lies between two order statistics, numbered from 1, so far from the first.
struct PercentilePlace {
    std::size_t first = 1, second = 1;
    double fraction = 0;
};

PercentilePlace percentilePlace(std::size_t count, double share)
{
    const double n = double(count);
    const double place = std::clamp((n + 1.0 / 3) * share + 1.0 / 3, 1.0, n);
    const std::size_t first = std::size_t(place);
    return {first, std::min(count, first + 1), place - double(first)};
}

struct Percentiles {
    double low = 0, median = 0, high = 0;
};

struct PercentileIndices {
    std::optional<double> spread;
    double nearest = 0;
};

double overWidth(double distance, double width)
{
    // values that all are one value: far from the limit or beyond it
    constexpr double least = 1e-300;
    return std::clamp(distance / std::max(width, least), -1e300, 1e300);
}

PercentileIndices indicesOf(const Percentiles& at, const ToleranceLimits& limits)
{
    PercentileIndices indices;
    if (limits.lower && limits.upper)
        indices.spread = overWidth(*limits.upper - *limits.lower, at.high - at.low);
    const double none = 1e300;
    const double lower = limits.lower ? overWidth(at.median - *limits.lower, at.median - at.low) : none;
    const double upper = limits.upper ? overWidth(*limits.upper - at.median, at.high - at.median) : none;
    indices.nearest = std::min(lower, upper);
    return indices;
}

Percentiles percentilesFrom(const std::array<double, 6>& orderStatistics,
                            const std::array<PercentilePlace, 3>& places)
{
    std::array<double, 3> at{};
    for (std::size_t i = 0; i < 3; ++i)
        at[i] = std::lerp(orderStatistics[2 * i], orderStatistics[2 * i + 1], places[i].fraction);
    return {at[0], at[1], at[2]};
}

std::array<PercentilePlace, 3> percentilePlaces(std::size_t count)
{
    std::array<PercentilePlace, 3> places{};
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = percentilePlace(count, percentileShares[i]);
    return places;
}

/// At the percentiles' order statistics, which these are the places of.
Percentiles percentilesAt(std::span<const double> sorted, const std::array<std::size_t, 6>& ranks,
                          const std::array<PercentilePlace, 3>& places)
{
    std::array<double, 6> statistics{};
    for (std::size_t i = 0; i < statistics.size(); ++i)
        statistics[i] = sorted[ranks[i]];
    return percentilesFrom(statistics, places);
}

TwoSidedInterval middleShare(std::vector<double> drawn, double confidence)
{
    std::sort(drawn.begin(), drawn.end());
    const auto at = [&drawn](double share) {
        const PercentilePlace place = percentilePlace(drawn.size(), share);
        return std::lerp(drawn[place.first - 1], drawn[place.second - 1], place.fraction);
    };
    return {at((1 - confidence) / 2), at((1 + confidence) / 2)};
}

std::optional<Error> checkPercentiles(std::span<const double> sorted, const PercentileOptions& options)
{
    if (std::optional<Error> problem = options.limits.validate())
        return problem;
    if (!(options.confidence > 0 && options.confidence < 1) || options.resamples < fewestResamples ||
        options.resamples > mostResamples)
        return Error{ErrorCode::Usage,
                     {Words::say("Confidence must be between 0 and 1, and resamples between %1 and %2.")
                          .arg(fewestResamples)
                          .arg(mostResamples)}};
    if (sorted.size() < fewestForPercentiles || !(sorted.back() > sorted.front()))
        return Error{ErrorCode::BadInput,
                     {Words::say("The values"), Words::say("they are too few, or do not vary"),
                      Words::say("at least %1 that differ were expected").arg(fewestForPercentiles)}};
    return {};
}

} // namespace

/// Order statistics of resamples with replacement: those of n uniform numbers, drawn one after another as
/// what they are given the one below, a beta of what is left; each is a place in the sorted values.
ResampledRanks resampledRanks(std::size_t count, int resamples, std::uint64_t seed)
{
    const std::array<PercentilePlace, 3> places = percentilePlaces(count);
    ResampledRanks ranks{count, std::vector<std::array<std::size_t, 6>>(std::size_t(resamples))};
    RandomStream random(seed, 0, 0);
    for (std::array<std::size_t, 6>& drawn : ranks.drawn) {
        std::size_t rank = 0;
        double uniform = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const PercentilePlace& place = places[i / 2];
            const std::size_t wanted = i % 2 == 0 ? place.first : place.second;
            if (wanted > rank) {
                const double step =
                    betaQuantile(random.uniform(), double(wanted - rank), double(count - wanted + 1));
                uniform += (1 - uniform) * step;
                rank = wanted;
            }
            drawn[i] = std::min(count - 1, std::size_t(uniform * double(count)));
        }
    }
    return ranks;
}

Expected<PercentileCapability> studyPercentileCapability(std::span<const double> values,
                                                         const PercentileOptions& options)
{
    const std::vector<double> sorted = sortedValues(values);
    RETURN_IF_ERROR(checkPercentiles(sorted, options));
    return studyPercentileCapability(sorted, resampledRanks(sorted.size(), options.resamples, options.seed),
                                     options);
}

Expected<PercentileCapability> studyPercentileCapability(std::span<const double> sorted,
                                                         const ResampledRanks& ranks,
                                                         const PercentileOptions& options)
{
    RETURN_IF_ERROR(checkPercentiles(sorted, options));
    const std::array<PercentilePlace, 3> places = percentilePlaces(sorted.size());
    std::array<std::size_t, 6> own{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        own[2 * i] = places[i].first - 1;
        own[2 * i + 1] = places[i].second - 1;
    }
    const Percentiles at = percentilesAt(sorted, own, places);
    if (!(at.low < at.median && at.median < at.high))
        return failure(ErrorCode::BadInput, {Words::say("The values"),
                                             Words::say("their percentiles coincide: too many are the same"),
                                             Words::say("record more digits")});
    const PercentileIndices indices = indicesOf(at, options.limits);
    PercentileCapability found{at.low, at.median, at.high, {}, {indices.nearest, {}}, 0, {}};
    std::vector<double> spreads, nearest;
    for (const std::array<std::size_t, 6>& resample : ranks.drawn) {
        const PercentileIndices drawn = indicesOf(percentilesAt(sorted, resample, places), options.limits);
        nearest.push_back(drawn.nearest);
        if (drawn.spread)
            spreads.push_back(*drawn.spread);
    }
    found.nearest.interval = middleShare(nearest, options.confidence);
    if (indices.spread)
        found.spread = CapabilityIndex{*indices.spread, middleShare(spreads, options.confidence)};
    const auto beyond = std::count_if(sorted.begin(), sorted.end(), [&options](double value) {
        return (options.limits.lower && value < *options.limits.lower) ||
               (options.limits.upper && value > *options.limits.upper);
    });
    found.observedPpm = 1e6 * double(beyond) / double(sorted.size());
    if (sorted.size() < enoughForPercentiles)
        found.messages.push_back(
            Words::say(
                "The outer percentiles of %1 values are about the smallest and the largest of them: the "
                "indices are too good. Take at least %2 values, or a distribution by Box and Cox.")
                .arg(sorted.size())
                .arg(enoughForPercentiles));
    return found;
}

} // namespace gripscope
