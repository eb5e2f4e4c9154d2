// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/gates.h"

#include "core/recognition/quiet_policy.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double dimensions = 3;
constexpr double tailDegrees = 5;

using ChiSquared = boost::math::chi_squared_distribution<double, QuietPolicy>;
using FisherF = boost::math::fisher_f_distribution<double, QuietPolicy>;

} // namespace

std::optional<double> predictiveGate(double degreesOfFreedom, double rate)
{
    const double v = degreesOfFreedom;
    if (!(v >= dimensions) || !(rate > 0 && rate < 1))
        return {};
    const double quantile = boost::math::quantile(boost::math::complement(FisherF(dimensions, v - 2), rate));
    const double gate = dimensions * v / (v - 2) * quantile;
    return std::isfinite(gate) ? std::optional(gate) : std::nullopt; // a rate next to 0 and v = 3
}

double chanceBeyond(double squaredDistance, double degreesOfFreedom, double count)
{
    const double ratio = squaredDistance * (degreesOfFreedom - 2) / (count * degreesOfFreedom);
    if (!std::isfinite(ratio))
        return 0;
    return boost::math::cdf(
        boost::math::complement(FisherF(count, degreesOfFreedom - 2), std::max(0.0, ratio)));
}

double chiSquaredGate(double rate)
{
    return boost::math::quantile(boost::math::complement(ChiSquared(dimensions), rate));
}

double heavyTailFactor(double rate)
{
    const double heavy =
        dimensions * (tailDegrees - 2) / tailDegrees *
        boost::math::quantile(boost::math::complement(FisherF(dimensions, tailDegrees), rate));
    return std::max(1.0, heavy / chiSquaredGate(rate));
}

} // namespace gripscope
