// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/polynomial.h"

#include <cmath>

namespace gripscope {

namespace {

/// The root in [low, high], where the values at the ends differ in sign.
long double bisect(std::span<const long double> coefficients, long double low, long double high)
{
    const bool rising = polynomialValue(coefficients, low) < 0;
    for (;;) {
        const long double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            return middle;
        if ((polynomialValue(coefficients, middle) < 0) == rising)
            low = middle;
        else
            high = middle;
    }
}

} // namespace

long double polynomialValue(std::span<const long double> coefficients, long double x)
{
    long double value = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;)
        value = value * x + coefficients[i];
    return value;
}

std::vector<long double> polynomialDerivative(std::span<const long double> coefficients)
{
    std::vector<long double> derivative;
    derivative.reserve(coefficients.size());
    for (std::size_t i = 1; i < coefficients.size(); ++i)
        derivative.push_back(static_cast<long double>(i) * coefficients[i]);
    return derivative;
}

std::vector<long double> polynomialRoots(std::span<const long double> coefficients, long double from,
                                         long double to)
{
    std::vector<long double> roots;
    if (coefficients.size() < 2)
        return roots;
    std::vector<long double> bounds{from};
    for (const long double turn : polynomialRoots(polynomialDerivative(coefficients), from, to))
        bounds.push_back(turn);
    bounds.push_back(to);
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        const long double first = polynomialValue(coefficients, bounds[i]);
        const long double last = polynomialValue(coefficients, bounds[i + 1]);
        if (first == 0 && (roots.empty() || roots.back() != bounds[i]))
            roots.push_back(bounds[i]);
        if (std::signbit(first) != std::signbit(last) && first != 0 && last != 0)
            roots.push_back(bisect(coefficients, bounds[i], bounds[i + 1]));
    }
    if (to > from && polynomialValue(coefficients, to) == 0)
        roots.push_back(to);
    return roots;
}

} // namespace gripscope
