// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/bias/capability_interval.h"

#include "core/math/distributions.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace gripscope {

namespace {

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
