// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/capability.h"

#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/math/sorted_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

constexpr double capableFrom = 4.0 / 3, barelyFrom = 1;
constexpr double normalityDoubt = 0.05;
constexpr std::size_t enoughForCapability = 50;

TwoSidedInterval bissellInterval(double index, double count, double degrees, double confidence)
{
    const double z = normalQuantileAbove((1 - confidence) / 2);
    const double half = z * std::sqrt(1 / (9 * count) + index * index / (2 * degrees));
    return {index - half, index + half};
}

/// Intervals of an unbiased sigma: the pivot is sigma times chiFactor.
void rescaleIntervals(CapabilityIndices& indices, double chiFactor)
{
    if (indices.spread) {
        indices.spread->interval.lower /= chiFactor;
        indices.spread->interval.upper /= chiFactor;
    }
}

double countBeyond(std::span<const double> values, const ToleranceLimits& limits)
{
    return double(std::count_if(values.begin(), values.end(), [&](double value) {
        return (limits.lower && value < *limits.lower) || (limits.upper && value > *limits.upper);
    }));
}

std::optional<double> targetOf(const CapabilityOptions& options)
{
    if (options.target || !options.limits.lower || !options.limits.upper)
        return options.target;
    return (*options.limits.lower + *options.limits.upper) / 2;
}

std::optional<CapabilityIndex> targetIndex(double mean, double sigma, double count,
                                           const CapabilityOptions& options)
{
    const std::optional<double> target = targetOf(options);
    if (!target || !options.limits.lower || !options.limits.upper)
        return {};
    const double off = (mean - *target) / sigma;
    const double value =
        (*options.limits.upper - *options.limits.lower) / (6 * sigma * std::sqrt(1 + off * off));
    const double degrees = count * std::pow(1 + off * off, 2) / (1 + 2 * off * off);
    return CapabilityIndex{value, intervalOverDeviation(value, degrees, options.confidence)};
}

void sayWhatToDoubt(Capability& found)
{
    if (found.normality && found.normality->p < normalityDoubt)
        found.messages.push_back(
            Words::say("The values are not normal (Anderson-Darling p %1): indices and ppm are not what they "
                       "seem. Take a distribution by Box and Cox, or percentiles.")
                .arg(found.normality->p, 'g', 3));
    if (!found.normality)
        found.messages.push_back(Words::say("Too few values to tell whether they are normal."));
    if (found.count < enoughForCapability)
        found.messages.push_back(Words::say("%1 values tell an index within wide bounds; take at least %2.")
                                     .arg(found.count)
                                     .arg(enoughForCapability));
    const double degrees = found.withinByEstimator.degreesOfFreedom;
    if (degrees < 0.98 * found.within.degreesOfFreedom)
        found.messages.push_back(
            Words::say(
                "The intervals of Cp and Cpk count %1 degrees of freedom, as is customary; sigma within "
                "subgroups is worth %2, and by these the intervals are wider; they stand beside.")
                .arg(found.within.degreesOfFreedom)
                .arg(degrees, 'f', 1));
    if (found.spread.sigma < 0.8 * found.overall.sigma)
        found.messages.push_back(
            Words::say("The values spread more overall than within subgroups: the process "
                       "moves. Look at its control chart first."));
}

constexpr std::size_t fewestForNormality = 8; // the formula of p is good from there
constexpr double largestAdjusted = 10;        // and up to there

/// log P(Z > z), also where that is below the smallest double.
double logNormalAbove(double z)
{
    if (z < 30)
        return std::log(normalAbove(z));
    // Mills's ratio: (1 - 1/z^2 + 3/z^4) phi(z)/z
    const double inverse = 1 / (z * z);
    return -z * z / 2 - std::log(z * std::sqrt(2 * std::numbers::pi)) +
           std::log1p(-inverse + 3 * inverse * inverse);
}

double chanceOfAdjusted(double a)
{
    if (a < 0.2)
        return 1 - std::exp(-13.436 + 101.14 * a - 223.73 * a * a);
    if (a < 0.34)
        return 1 - std::exp(-8.318 + 42.796 * a - 59.938 * a * a);
    if (a < 0.6)
        return std::exp(0.9177 - 4.279 * a - 1.38 * a * a);
    a = std::min(a, largestAdjusted);
    return std::exp(1.2937 - 5.709 * a + 0.0186 * a * a);
}

} // namespace

CapabilityIndices capabilityIndices(double mean, double sigma, double count, double degreesOfFreedom,
                                    const CapabilityOptions& options)
{
    const ToleranceLimits& limits = options.limits;
    CapabilityIndices indices;
    indices.sigma = sigma;
    indices.degreesOfFreedom = degreesOfFreedom;
    double beyond = 0;
    if (limits.lower) {
        indices.lower = (mean - *limits.lower) / (3 * sigma);
        beyond += normalAbove(3 * *indices.lower);
    }
    if (limits.upper) {
        indices.upper = (*limits.upper - mean) / (3 * sigma);
        beyond += normalAbove(3 * *indices.upper);
    }
    indices.expectedPpm = 1e6 * beyond;
    if (limits.lower && limits.upper) {
        const double value = (*limits.upper - *limits.lower) / (6 * sigma);
        indices.spread =
            CapabilityIndex{value, intervalOverDeviation(value, degreesOfFreedom, options.confidence)};
    }
    const double nearest = !indices.lower   ? *indices.upper
                           : !indices.upper ? *indices.lower
                                            : std::min(*indices.lower, *indices.upper);
    indices.nearest = {nearest, bissellInterval(nearest, count, degreesOfFreedom, options.confidence)};
    return indices;
}

Expected<Capability> studyCapability(const Subgroups& groups, const CapabilityOptions& options)
{
    return studyCapability(groups, sortedValues(groups.values), options);
}

Expected<Capability> studyCapability(const Subgroups& groups, std::span<const double> sorted,
                                     const CapabilityOptions& options)
{
    RETURN_IF_ERROR(options.limits.validate());
    if (!(options.confidence > 0 && options.confidence < 1))
        return failure(ErrorCode::Usage, {Words::say("The confidence must be between 0 and 1.")});
    if (options.target && !std::isfinite(*options.target))
        return failure(ErrorCode::Usage, {Words::say("The target must be a finite number.")});
    Capability found;
    ASSIGN_OR_RETURN(found.spread, withinSpread(groups, options.within));
    const SubgroupSummary all = summaryOf(groups.values);
    const double count = double(all.size);
    found.count = all.size;
    found.mean = all.mean;
    found.within = capabilityIndices(all.mean, found.spread.sigma, count, count - 1, options);
    found.overall = capabilityIndices(all.mean, all.deviation, count, count - 1, options);
    found.withinByEstimator =
        capabilityIndices(all.mean, found.spread.sigma, count, found.spread.degreesOfFreedom, options);
    rescaleIntervals(found.withinByEstimator, found.spread.chiFactor);
    found.target = targetIndex(all.mean, all.deviation, count, options);
    if (const Expected<NormalityTest> test = testNormality(sorted, all))
        found.normality = *test;
    found.observedPpm = 1e6 * countBeyond(groups.values, options.limits) / count;
    sayWhatToDoubt(found);
    return found;
}

Finding capabilityVerdict(const CapabilityIndex& nearest)
{
    if (nearest.interval.lower >= capableFrom)
        return Words::say("Capable: the index is 1.33 or more, and so is the lower end of its interval.");
    if (nearest.value >= capableFrom)
        return Words::say("Probably capable: the index is 1.33 or more, but its interval reaches down to %1. "
                          "Measure more parts to be sure.")
            .arg(nearest.interval.lower, 'f', 2);
    if (nearest.interval.upper < barelyFrom)
        return Words::say("Not capable: the index is below 1, and so is its interval. Centre the process, or "
                          "make it vary less.");
    if (nearest.value < barelyFrom)
        return Words::say(
                   "Not capable as it seems: the index is below 1, its interval reaches up to %1. Centre "
                   "the process, or make it vary less.")
            .arg(nearest.interval.upper, 'f', 2);
    return Words::say(
        "Barely capable: the index is between 1 and 1.33. Watch the process, centre it, or make "
        "it vary less.");
}

Expected<NormalityTest> testNormality(std::span<const double> values)
{
    return testNormality(sortedValues(values), summaryOf(values));
}

Expected<NormalityTest> testNormality(std::span<const double> sorted, const SubgroupSummary& summary)
{
    if (sorted.size() < fewestForNormality)
        return failure(ErrorCode::BadInput,
                       {Words::say("The test of normality"),
                        Words::say("there are %1 values").arg(sorted.size()),
                        Words::say("at least %1 were expected").arg(fewestForNormality)});
    if (!(summary.deviation > 0) || !std::isfinite(summary.deviation))
        return failure(ErrorCode::BadInput,
                       {Words::say("The test of normality"), Words::say("the values do not vary"),
                        Words::say("record more digits")});
    const std::size_t count = sorted.size();
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double below = (sorted[i] - summary.mean) / summary.deviation;
        const double above = (sorted[count - 1 - i] - summary.mean) / summary.deviation;
        sum += (2 * double(i) + 1) * (logNormalAbove(-below) + logNormalAbove(above));
    }
    const double n = double(count);
    NormalityTest test;
    test.statistic = -n - sum / n;
    test.adjusted = test.statistic * (1 + 0.75 / n + 2.25 / (n * n));
    test.p = chanceOfAdjusted(test.adjusted);
    return test;
}

} // namespace gripscope
