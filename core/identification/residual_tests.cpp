// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/residual_tests.h"

#include "core/identification/fit.h"

#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {
constexpr std::size_t largestLag = 20;
} // namespace

std::optional<double> ljungBoxP(std::span<const double> residuals, int fittedLags)
{
    const std::size_t lags = std::min(largestLag, residuals.size() / 5);
    const int degreesOfFreedom = static_cast<int>(lags) - fittedLags;
    if (degreesOfFreedom < 1)
        return std::nullopt;
    const double scale = powerOfTwoScale(residuals);
    const auto count = static_cast<double>(residuals.size());
    double mean = 0;
    for (const double e : residuals)
        mean += e / scale;
    mean /= count;
    const auto covariance = [&](std::size_t lag) {
        double sum = 0;
        for (std::size_t i = lag; i < residuals.size(); ++i)
            sum += (residuals[i] / scale - mean) * (residuals[i - lag] / scale - mean);
        return sum;
    };
    const double variance = covariance(0);
    if (!(variance > 0) || !std::isfinite(variance))
        return std::nullopt;
    double q = 0;
    for (std::size_t lag = 1; lag <= lags; ++lag) {
        const double r = covariance(lag) / variance;
        q += r * r / (count - static_cast<double>(lag));
    }
    q *= count * (count + 2);
    const boost::math::chi_squared distribution(degreesOfFreedom);
    return boost::math::cdf(boost::math::complement(distribution, q));
}

} // namespace gripscope
