// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/bias/type_one_study.h"

#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/math/sample_moments.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::optional<double> ifFinite(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Differences that are nothing but the rounding of decimal numbers are none.
std::optional<double> smallestStep(std::span<const double> readings)
{
    std::vector<double> sorted(readings.begin(), readings.end());
    std::sort(sorted.begin(), sorted.end());
    const double largest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * largest;
    std::optional<double> step;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const double difference = sorted[i] - sorted[i - 1];
        if (difference > rounding && (!step || difference < *step))
            step = difference;
    }
    return step;
}

std::optional<Error> unusableReadings(std::span<const double> readings)
{
    if (readings.size() < 2)
        return Error{ErrorCode::BadInput,
                     {Words::say("readings of the reference part"),
                      Words::say("found %1").arg(readings.size()),
                      Words::say("expected at least 2, better 50: squeeze the part again")}};
    if (!std::all_of(readings.begin(), readings.end(), [](double reading) { return std::isfinite(reading); }))
        return Error{ErrorCode::BadInput,
                     {Words::say("readings of the reference part"),
                      Words::say("found a number that is not finite"),
                      Words::say("expected finite numbers")}};
    return {};
}

void addScatter(const TypeOneOptions& options, TypeOneStudy& study)
{
    const double s = study.repeatability, degrees = double(study.count - 1);
    const double error = s / std::sqrt(double(study.count));
    const double half = studentQuantileAbove((1 - options.confidence) / 2, degrees) * error;
    study.biasInterval = TwoSidedInterval{study.bias - half, study.bias + half};
    study.repeatabilityInterval = deviationInterval(s, study.count, options.confidence);
    study.t = ifFinite(study.bias / error);
    study.p = study.t ? 2 * studentAbove(std::abs(*study.t), degrees) : 0;
    study.biased = *study.p < 1 - options.confidence;
    study.cg = ifFinite(options.sharePercent / 100 * options.tolerance / (options.sigmas * s));
    study.cgk = ifFinite((options.sharePercent / 200 * options.tolerance - std::abs(study.bias)) /
                         (options.sigmas / 2 * s));
    if (study.cg)
        study.cgInterval = capabilityInterval(*study.cg, study.count, options.confidence);
    if (study.cgk)
        study.cgkInterval =
            biasedCapabilityInterval(*study.cgk, options.sigmas, study.count, options.confidence);
    if (study.cgk && *study.cgk > 0)
        study.biasedVariationPercent = ifFinite(options.sharePercent / *study.cgk);
}

/// Beyond it the mean is known so much better than the deviation that only the latter counts, to 1e-6.
constexpr double largestShift = 1000;

/// The d for which P(T <= t) = `below`, T Student's with the shift d: it falls as d rises.
double shiftWith(double t, double degrees, double below)
{
    const auto excess = [&](double shift) { return nonCentralStudentBelow(t, degrees, shift) - below; };
    const double step = 1 + 2 * std::abs(t) / std::sqrt(2 * degrees);
    double lower = t - step, upper = t + step;
    double atLower = excess(lower), atUpper = excess(upper);
    for (int i = 0; i < 60 && atLower < 0; ++i)
        atLower = excess(lower -= step);
    for (int i = 0; i < 60 && atUpper > 0; ++i)
        atUpper = excess(upper += step);
    if (!(atLower > 0 && atUpper < 0))
        return atLower == 0 ? lower : upper;
    std::uintmax_t rounds = 100;
    const auto found = boost::math::tools::toms748_solve(
        excess, lower, upper, atLower, atUpper, boost::math::tools::eps_tolerance<double>(44), rounds);
    return (found.first + found.second) / 2;
}

} // namespace

std::optional<Error> TypeOneOptions::validate() const
{
    const auto wrong = [](const Finding& reason) { return Error{ErrorCode::Usage, {reason}}; };
    if (!std::isfinite(reference))
        return wrong(Words::say("The reference must be a finite number."));
    if (!(std::isfinite(tolerance) && tolerance > 0))
        return wrong(Words::say("The tolerance must be a number above zero."));
    if (!(sharePercent > 0 && sharePercent <= 100))
        return wrong(Words::say("The share of the tolerance must be above 0 and at most 100 percent."));
    if (!(sigmas > 0 && sigmas <= 100))
        return wrong(Words::say("The spread must be above 0 and at most 100 standard deviations."));
    if (!(minimum > 0 && std::isfinite(minimum)))
        return wrong(Words::say("The minimum of Cg and Cgk must be a number above zero."));
    if (!(confidence > 0 && confidence < 1))
        return wrong(Words::say("The confidence must lie between 0 and 1."));
    return {};
}

Expected<TypeOneStudy> studyTypeOne(std::span<const double> readings, const TypeOneOptions& options)
{
    RETURN_IF_ERROR(options.validate());
    RETURN_IF_ERROR(unusableReadings(readings));
    const SampleMoments moments = sampleMoments(readings);
    TypeOneStudy study;
    study.count = moments.count;
    study.mean = moments.mean;
    study.bias = moments.mean - options.reference;
    study.repeatability = moments.standardDeviation;
    study.variationPercent = 100 * options.sigmas * study.repeatability / options.tolerance;
    study.largestVariationPercent = options.sharePercent / options.minimum;
    const double spread = options.minimum * options.sigmas * study.repeatability;
    study.leastTolerance = 100 / options.sharePercent * spread;
    study.leastBiasedTolerance = 200 / options.sharePercent * (spread / 2 + std::abs(study.bias));
    if (!std::isfinite(study.leastBiasedTolerance) || !std::isfinite(study.variationPercent) ||
        !std::isfinite(study.leastTolerance) || !std::isfinite(study.mean))
        return failure(ErrorCode::BadInput, {Words::say("readings of the reference part"),
                                             Words::say("found numbers too large to calculate with"),
                                             Words::say("expected another unit")});
    study.step = smallestStep(readings);
    if (study.step)
        study.stepPercent = ifFinite(100 * *study.step / options.tolerance);
    if (study.repeatability > 0)
        addScatter(options, study);
    else
        study.biased = study.bias != 0;
    study.capable = study.cg && study.cgk && *study.cg >= options.minimum && *study.cgk >= options.minimum &&
                    study.stepPercent && *study.stepPercent <= largestStepPercent;
    study.messages = inWords(study, options);
    return study;
}

std::optional<TwoSidedInterval> deviationInterval(double deviation, std::size_t count, double confidence)
{
    if (count < 2 || !std::isfinite(deviation))
        return {};
    const double degrees = double(count - 1), beyond = (1 - confidence) / 2;
    return TwoSidedInterval{deviation * std::sqrt(degrees / chiSquaredQuantileAbove(beyond, degrees)),
                            deviation * std::sqrt(degrees / chiSquaredQuantile(beyond, degrees))};
}

std::optional<TwoSidedInterval> capabilityInterval(double cg, std::size_t count, double confidence)
{
    if (count < 2 || !std::isfinite(cg))
        return {};
    return intervalOverDeviation(cg, double(count - 1), confidence);
}

std::optional<TwoSidedInterval> biasedCapabilityInterval(double cgk, double sigmas, std::size_t count,
                                                         double confidence)
{
    if (count < 2 || !std::isfinite(cgk))
        return {};
    const double scale = std::sqrt(double(count)) * sigmas / 2;
    const double t = scale * cgk, degrees = double(count - 1), beyond = (1 - confidence) / 2;
    if (std::abs(t) > largestShift)
        return capabilityInterval(cgk, count, confidence);
    return TwoSidedInterval{shiftWith(t, degrees, 1 - beyond) / scale, shiftWith(t, degrees, beyond) / scale};
}

} // namespace gripscope
