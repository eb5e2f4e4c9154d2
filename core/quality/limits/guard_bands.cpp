// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/limits/guard_bands.h"

#include "core/base/words.h"
#include "core/math/distributions.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace gripscope {

namespace {

constexpr double farAway = 12; ///< deviations beyond which nothing of a normal distribution counts

Error wrongLimits(const Finding& words)
{
    return Error{ErrorCode::Usage, {words}};
}

double lowerOf(const ToleranceLimits& limits)
{
    return limits.lower.value_or(-std::numeric_limits<double>::infinity());
}
double upperOf(const ToleranceLimits& limits)
{
    return limits.upper.value_or(std::numeric_limits<double>::infinity());
}

/// Between the limits, of a normal quantity: by the tail that keeps its digits.
double normalBetween(double lower, double upper, double mean, double deviation)
{
    const double low = (lower - mean) / deviation;
    const double high = (upper - mean) / deviation;
    if (!(low < high))
        return 0;
    return low > 0 ? normalBelow(-low) - normalBelow(-high) : normalBelow(high) - normalBelow(low);
}

double densityOf(const MeasuredProcess& process, double part)
{
    const double z = (part - process.mean) / process.deviation;
    return std::exp(-z * z / 2) / (process.deviation * std::sqrt(2 * std::numbers::pi));
}

/// The integral of density times weight from `from` to `to`, in pieces no longer than the sharpest feature.
template <typename Weight>
double integrate(const MeasuredProcess& process, double from, double to, const Weight& weight)
{
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
    const double low = std::max(from, process.mean - farAway * process.deviation);
    const double high = std::min(to, process.mean + farAway * process.deviation);
    if (!(low < high))
        return 0;
    // A measurement much sharper than the process makes steps at the limits: the pieces end there.
    std::vector<double> ends{low, high};
    for (const double limit : {lowerOf(process.limits), upperOf(process.limits)})
        for (const double away : {-farAway, -3.0, 0.0, 3.0, farAway})
            if (const double end = limit + away * process.uncertainty; end > low && end < high)
                ends.push_back(end);
    std::ranges::sort(ends);
    double sum = 0;
    for (std::size_t i = 1; i < ends.size(); ++i)
        sum += Quadrature::integrate([&](double part) { return densityOf(process, part) * weight(part); },
                                     ends[i - 1], ends[i], 12, 1e-12);
    return sum;
}

/// About its mean: far from zero the rounding of each value would keep the quadrature from ever settling.
MeasuredProcess centredProcess(MeasuredProcess process)
{
    for (std::optional<double>* limit : {&process.limits.lower, &process.limits.upper})
        if (*limit)
            **limit -= process.mean;
    process.mean = 0;
    return process;
}

GlobalRisks risksOf(const MeasuredProcess& given, double guard)
{
    const MeasuredProcess process = centredProcess(given);
    const double lower = lowerOf(process.limits);
    const double upper = upperOf(process.limits);
    const auto accepted = [&](double part) {
        return normalBetween(lower + guard, upper - guard, part, process.uncertainty);
    };
    const auto rejected = [&](double part) {
        const double far = std::numeric_limits<double>::infinity();
        if (!(lower + guard < upper - guard))
            return 1.0;
        return normalBetween(-far, lower + guard, part, process.uncertainty) +
               normalBetween(upper - guard, far, part, process.uncertainty);
    };
    GlobalRisks risks;
    risks.consumers = integrate(process, -std::numeric_limits<double>::infinity(), lower, accepted) +
                      integrate(process, upper, std::numeric_limits<double>::infinity(), accepted);
    risks.producers = integrate(process, lower, upper, rejected);
    return risks;
}

} // namespace

std::optional<Error> MeasuredProcess::validate() const
{
    if (std::optional<Error> problem = limits.validate())
        return problem;
    for (const double value : {deviation, uncertainty})
        if (!std::isfinite(value) || !(value > 0))
            return wrongLimits(
                Words::say("the deviations of the process and of the measurement are numbers above zero"));
    if (!std::isfinite(mean))
        return wrongLimits(Words::say("the mean of the process is no finite number"));
    return std::nullopt;
}

Expected<GlobalRisks> globalRisks(const MeasuredProcess& process, double guard)
{
    if (std::optional<Error> problem = process.validate())
        return tl::unexpected(*problem);
    if (!std::isfinite(guard))
        return failure(ErrorCode::Usage, {Words::say("the guard band is no finite number")});
    return risksOf(process, guard);
}

Expected<std::optional<double>> guardForRisk(const MeasuredProcess& process, double risk)
{
    if (std::optional<Error> problem = process.validate())
        return tl::unexpected(*problem);
    if (!(risk > 0 && risk < 1))
        return failure(ErrorCode::Usage, {Words::say("a risk is between 0 and 1")});
    constexpr int halvings = 60;
    const double width = farAway * (process.uncertainty + process.deviation);
    double low = -width;
    double high = width;
    if (process.limits.lower && process.limits.upper)
        high = std::min(high, (*process.limits.upper - *process.limits.lower) / 2);
    if (risksOf(process, low).consumers <= risk)
        return std::optional<double>(); // with no inspection at all it is no more
    if (risksOf(process, high).consumers > risk)
        return std::optional<double>();
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (risksOf(process, middle).consumers > risk ? low : high) = middle;
    }
    return std::optional(high);
}

double guardForSpecificRisk(double uncertainty, double risk)
{
    return normalQuantileAbove(risk) * uncertainty;
}

double conformanceProbability(const ToleranceLimits& limits, double value, double uncertainty,
                              const std::optional<PartsBefore>& before)
{
    double mean = value;
    double deviation = uncertainty;
    if (before && before->deviation > 0) {
        const double own = 1 / (uncertainty * uncertainty);
        const double others = 1 / (before->deviation * before->deviation);
        mean = (own * value + others * before->mean) / (own + others);
        deviation = 1 / std::sqrt(own + others);
    }
    return normalBetween(lowerOf(limits), upperOf(limits), mean, deviation);
}

PartDecision decide(double conformanceProbability, double risk)
{
    if (1 - conformanceProbability <= risk)
        return PartDecision::Conforms;
    return conformanceProbability <= risk ? PartDecision::DoesNotConform : PartDecision::TooNearTheLimit;
}

} // namespace gripscope
