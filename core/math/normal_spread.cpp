// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/normal_spread.h"

#include "core/math/distributions.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace gripscope {

namespace {

using RangeQuadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
constexpr double farthestNormal = 12; // P(x > 12) = 2e-33
constexpr double quadratureTolerance = 1e-11;
constexpr unsigned quadratureDepth = 10;

/// P(R > w) = 1 - n int phi(x) [Phi(x + w) - Phi(x)]^(n-1) dx, by the trapezoidal rule: for what is analytic
/// and dies off at both ends it converges faster than any power of the step. x is taken about -w/2, where
/// the integrand has its mass.
class RangeAbove {
public:
    explicit RangeAbove(int size) : m_size(size) {}

    [[nodiscard]] double operator()(double width) const
    {
        double sum = 0;
        for (int i = -steps; i <= steps; ++i) {
            const double x = step * i - width / 2;
            const double inside = normalBelow(x + width) - normalBelow(x);
            if (inside > 0)
                sum += normalDensity(x) * std::pow(inside, m_size - 1);
        }
        return std::max(0.0, 1 - m_size * step * sum);
    }

private:
    static constexpr int steps = 215; // to 17 either way: half the widest range and 9 deviations
    static constexpr double step = 0.08;
    int m_size;
};

} // namespace

double meanNormalRange(int size)
{
    const double n = std::max(2, size);
    return 2 * RangeQuadrature::integrate(
                   [n](double x) {
                       const double above = normalAbove(x);
                       return -std::expm1(n * std::log1p(-above)) - std::pow(above, n);
                   },
                   0.0, farthestNormal, quadratureDepth, quadratureTolerance);
}

namespace {

RangeMoments integratedRangeMoments(int n)
{
    const RangeAbove above(n);
    const double meanSquare =
        2 * RangeQuadrature::integrate([&above](double width) { return width * above(width); }, 0.0,
                                       farthestNormal + 4, quadratureDepth, quadratureTolerance);
    const double mean = meanNormalRange(n);
    return {mean, std::sqrt(meanSquare - mean * mean)};
}

} // namespace

RangeMoments rangeMoments(int size)
{
    // Charts ask for the same few sizes again and again.
    static thread_local std::array<std::optional<RangeMoments>, 65> known;
    const int n = std::max(2, size);
    if (std::size_t(n) >= known.size())
        return integratedRangeMoments(n);
    std::optional<RangeMoments>& one = known[std::size_t(n)];
    if (!one)
        one = integratedRangeMoments(n);
    return *one;
}

double deviationBias(double degreesOfFreedom)
{
    // Gamma(a) / Gamma(a + 1/2) without the difference of two large logarithms
    return std::sqrt(2 / degreesOfFreedom) / boost::math::tgamma_delta_ratio(degreesOfFreedom / 2, 0.5);
}

double equivalentDegrees(double relativeVariance)
{
    double low = 0.01, high = 1e9;
    for (int halving = 0; halving < 200 && high / low > 1 + 1e-14; ++halving) {
        const double middle = std::sqrt(low * high);
        const double bias = deviationBias(middle);
        (1 / (bias * bias) - 1 > relativeVariance ? low : high) = middle;
    }
    return high;
}

} // namespace gripscope
