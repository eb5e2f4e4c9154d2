// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/box_cox.h"

#include "core/base/words.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double farthestPower = 5;
constexpr std::size_t fewestForPower = 8;

double geometricMean(std::span<const double> values)
{
    double sum = 0;
    for (const double value : values)
        sum += std::log(value);
    return std::exp(sum / double(values.size()));
}

/// -2/n times the log-likelihood; the second term is 0 for logarithms that sum to 0.
double powerMisfit(std::span<const double> scaledLogs, double lambda)
{
    double sum = 0, squares = 0;
    for (const double log : scaledLogs) {
        const double y = std::abs(lambda) < 1e-12 ? log : std::expm1(lambda * log) / lambda;
        sum += y;
        squares += y * y;
    }
    const double n = double(scaledLogs.size());
    return std::log(std::max(1e-300, squares / n - sum / n * (sum / n)));
}

tl::unexpected<Error> notAboveZero(const Finding& what, double value)
{
    return failure(ErrorCode::BadInput, {what, Words::say("it is %1").arg(value),
                                         Words::say("a power needs numbers above 0; take percentiles")});
}

} // namespace

double boxCox(double x, double lambda)
{
    return std::abs(lambda) < 1e-12 ? std::log(x) : std::expm1(lambda * std::log(x)) / lambda;
}

Expected<double> bestBoxCox(std::span<const double> values)
{
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(values[i] > 0))
            return notAboveZero(Words::say("Value %1").arg(i + 1), values[i]);
    if (values.size() < fewestForPower || !(summaryOf(values).range > 0))
        return failure(ErrorCode::BadInput,
                       {Words::say("The values"), Words::say("they are too few, or do not vary"),
                        Words::say("at least %1 that differ were expected").arg(fewestForPower)});
    const double mean = geometricMean(values);
    std::vector<double> logs;
    logs.reserve(values.size());
    for (const double value : values)
        logs.push_back(std::log(value / mean));
    const auto best = boost::math::tools::brent_find_minima(
        [&logs](double lambda) { return powerMisfit(logs, lambda); }, -farthestPower, farthestPower, 26);
    return best.first;
}

Expected<TransformedCapability> studyBoxCoxCapability(const Subgroups& groups,
                                                      const CapabilityOptions& options)
{
    RETURN_IF_ERROR(options.limits.validate());
    TransformedCapability found;
    ASSIGN_OR_RETURN(found.lambda, bestBoxCox(groups.values));
    found.scale = geometricMean(groups.values);
    const auto transformed = [&found](double x) { return boxCox(x / found.scale, found.lambda); };
    CapabilityOptions there = options;
    const bool lowerIsIdle = options.limits.lower && *options.limits.lower <= 0;
    if (options.limits.upper && !(*options.limits.upper > 0))
        return notAboveZero(Words::say("The upper limit"), *options.limits.upper);
    if (options.target && !(*options.target > 0))
        return notAboveZero(Words::say("The target"), *options.target);
    if (lowerIsIdle && !options.limits.upper)
        return notAboveZero(Words::say("The lower limit"), *options.limits.lower);
    if (lowerIsIdle)
        there.limits.lower.reset();
    for (std::optional<double>* limit : {&there.limits.lower, &there.limits.upper, &there.target})
        if (*limit)
            *limit = transformed(**limit);
    Subgroups values = groups;
    std::transform(values.values.begin(), values.values.end(), values.values.begin(), transformed);
    ASSIGN_OR_RETURN(found.capability, studyCapability(values, there));
    if (lowerIsIdle)
        found.capability.messages.push_back(
            Words::say("The lower limit %1 cannot be passed by values above 0; only the upper one counts.")
                .arg(*options.limits.lower));
    return found;
}

} // namespace gripscope
