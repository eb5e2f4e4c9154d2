// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/limits/tolerance_factors.h"

#include "core/base/words.h"
#include "core/math/distributions.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

constexpr int toleranceHalvings = 100;

/// Half the width about a mean that is off by x, which holds the share of a standard normal.
double halfWidth(double x, double content)
{
    double low = 0;
    double high = std::abs(x) + normalQuantile((1 + content) / 2) + 1;
    for (int i = 0; i < toleranceHalvings; ++i) {
        const double middle = (low + high) / 2;
        const double held = normalBelow(x + middle) - normalBelow(x - middle);
        (held < content ? low : high) = middle;
    }
    return high;
}

/// The probability that mean +- k s holds the content.
double confidenceOf(double k, const ToleranceInterval& interval)
{
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
    const double root = std::sqrt(static_cast<double>(interval.count));
    const double degrees = interval.count - 1;
    const auto integrand = [&](double z) { // z = sqrt(n) x
        const double r = halfWidth(z / root, interval.content);
        const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
        return density * chiSquaredAbove(degrees * r * r / (k * k), degrees);
    };
    return 2 * Quadrature::integrate(integrand, 0.0, 9.0, 8, 1e-11);
}

} // namespace

std::optional<Error> ToleranceInterval::validate() const
{
    if (count < 2)
        return Error{ErrorCode::Usage, {Words::say("a tolerance interval needs two values at least")}};
    for (const double share : {content, confidence})
        if (!(share > 0 && share < 1))
            return Error{ErrorCode::Usage, {Words::say("content and confidence are between 0 and 1")}};
    return std::nullopt;
}

Expected<double> oneSidedToleranceFactor(const ToleranceInterval& interval)
{
    if (std::optional<Error> problem = interval.validate())
        return tl::unexpected(*problem);
    const double root = std::sqrt(static_cast<double>(interval.count));
    return nonCentralStudentQuantile(interval.confidence, interval.count - 1,
                                     normalQuantile(interval.content) * root) /
           root;
}

Expected<double> twoSidedToleranceFactor(const ToleranceInterval& interval)
{
    if (std::optional<Error> problem = interval.validate())
        return tl::unexpected(*problem);
    double low = 0;
    double high = normalQuantile((1 + interval.content) / 2);
    while (confidenceOf(high, interval) < interval.confidence && high < 1e6)
        high *= 2;
    for (int i = 0; i < 60 && high - low > 1e-11 * high; ++i) {
        const double middle = (low + high) / 2;
        (middle > 0 && confidenceOf(middle, interval) >= interval.confidence ? high : low) = middle;
    }
    return high;
}

} // namespace gripscope
