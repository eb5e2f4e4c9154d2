// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/within_spread.h"

#include "core/base/words.h"
#include "core/math/normal_spread.h"
#include "core/quality/charts/chart_constants.h"

#include <cmath>
#include <map>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t largestForRanges = 10; // beyond, a range wastes more than a seventh of what values say

SpreadMethod chosenSpread(const Subgroups& groups, SpreadMethod method)
{
    if (method != SpreadMethod::Automatic)
        return method;
    const std::size_t largest = groups.layout.largest();
    if (largest < 2)
        return SpreadMethod::MovingRange;
    return largest <= largestForRanges ? SpreadMethod::Range : SpreadMethod::Deviation;
}

tl::unexpected<Error> tooFewForSpread(const Finding& found, const Finding& expected)
{
    return failure(ErrorCode::BadInput, {Words::say("The subgroups"), found, expected});
}

Expected<WithinSpread> spreadOfMovingRanges(const Subgroups& groups)
{
    if (groups.layout.largest() > 1)
        return tooFewForSpread(
            Words::say("they hold several values each"),
            Words::say("moving ranges are of individual values; take ranges or deviations"));
    const std::vector<double>& values = groups.values;
    if (values.size() < 2)
        return tooFewForSpread(Words::say("there is one value"),
                               Words::say("at least two are needed to see how values differ"));
    double sum = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        sum += std::abs(values[i] - values[i - 1]);
    const double ranges = double(values.size() - 1);
    const double d2 = 2 / std::sqrt(std::numbers::pi);
    const double variance = 2 - d2 * d2;
    const double neighbours = 4 / std::numbers::pi * (std::sqrt(3.0) / 2 + std::numbers::pi / 12) - d2 * d2;
    const double relative = (ranges * variance + 2 * (ranges - 1) * neighbours) / (ranges * ranges * d2 * d2);
    WithinSpread spread{SpreadMethod::MovingRange, sum / ranges / d2, equivalentDegrees(relative), 1, 0};
    spread.chiFactor = deviationBias(spread.degreesOfFreedom);
    return spread;
}

/// Of each size once; d3 is a double integral.
class ConstantsOfSizes {
public:
    const ChartConstants& operator()(std::size_t size)
    {
        const auto place = m_known.try_emplace(size);
        if (place.second)
            place.first->second = chartConstants(int(size));
        return place.first->second;
    }

private:
    std::map<std::size_t, ChartConstants> m_known;
};

struct SpreadWeight {
    double weight;   ///< 1 over the relative variance of one subgroup's estimate
    double unbiased; ///< its estimate of sigma
};

SpreadWeight spreadOfOne(const SubgroupSummary& summary, SpreadMethod method, ConstantsOfSizes& constants)
{
    if (method == SpreadMethod::Range) {
        const ChartConstants& of = constants(summary.size);
        return {of.d2 * of.d2 / (of.d3 * of.d3), summary.range / of.d2};
    }
    const double c4 = deviationBias(double(summary.size - 1));
    return {c4 * c4 / (1 - c4 * c4), summary.deviation / c4};
}

Expected<WithinSpread> spreadOfSubgroups(const Subgroups& groups, SpreadMethod method)
{
    ConstantsOfSizes constants;
    WithinSpread spread;
    spread.method = method;
    double weights = 0, sum = 0, squares = 0, degrees = 0;
    for (std::size_t i = 0; i < groups.count(); ++i) {
        if (groups.layout.size(i) < 2) {
            ++spread.singles;
            continue;
        }
        const SubgroupSummary summary = summaryOf(groups[i]);
        degrees += double(summary.size - 1);
        squares += double(summary.size - 1) * summary.deviation * summary.deviation;
        if (method == SpreadMethod::Pooled)
            continue;
        const SpreadWeight one = spreadOfOne(summary, method, constants);
        weights += one.weight;
        sum += one.weight * one.unbiased;
    }
    if (!(degrees > 0))
        return tooFewForSpread(
            Words::say("each holds one value"),
            Words::say("subgroups of at least two, or a chart of individuals, were expected"));
    if (method == SpreadMethod::Pooled) {
        spread.sigma = std::sqrt(squares / degrees);
        spread.degreesOfFreedom = degrees;
        return spread;
    }
    spread.sigma = sum / weights;
    spread.degreesOfFreedom = equivalentDegrees(1 / weights);
    spread.chiFactor = deviationBias(spread.degreesOfFreedom);
    return spread;
}

} // namespace

QString toString(SpreadMethod method)
{
    switch (method) {
    case SpreadMethod::Automatic:
        return u"automatic"_s;
    case SpreadMethod::MovingRange:
        return u"moving_range"_s;
    case SpreadMethod::Range:
        return u"range"_s;
    case SpreadMethod::Deviation:
        return u"deviation"_s;
    case SpreadMethod::Pooled:
        return u"pooled"_s;
    }
    return {};
}

Expected<WithinSpread> withinSpread(const Subgroups& groups, SpreadMethod method)
{
    const SpreadMethod chosen = chosenSpread(groups, method);
    ASSIGN_OR_RETURN(const WithinSpread spread, chosen == SpreadMethod::MovingRange
                                                    ? spreadOfMovingRanges(groups)
                                                    : spreadOfSubgroups(groups, chosen));
    if (!(spread.sigma > 0) || !std::isfinite(spread.sigma))
        return failure(ErrorCode::BadInput,
                       {Words::say("The values"), Words::say("they do not vary within subgroups"),
                        Words::say("record more digits, or state sigma")});
    return spread;
}

} // namespace gripscope
