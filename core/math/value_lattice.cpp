// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/value_lattice.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscope {

namespace {

constexpr std::size_t fewestLevels = 8;
constexpr double finestStep = 1e-6;           ///< of the range
constexpr double latticeRounding = 1e-9;      ///< of the largest value
constexpr std::size_t mostLookedAt = 1 << 16; ///< more of them tell nothing new

/// Steps between neighbouring different values, smallest first.
std::vector<double> stepsBetween(std::vector<double> values, double tolerance)
{
    std::sort(values.begin(), values.end());
    std::vector<double> steps;
    double last = values.front();
    for (const double value : values) {
        if (value - last <= tolerance)
            continue;
        steps.push_back(value - last);
        last = value;
    }
    std::sort(steps.begin(), steps.end());
    return steps;
}

/// The remainder of `a` by `b`, zero when it is one but for rounding.
double remainderOf(double a, double b, double tolerance)
{
    const double rest = a - b * std::round(a / b);
    return std::abs(rest) <= tolerance ? 0 : std::abs(rest);
}

} // namespace

std::optional<double> latticeStep(std::span<const double> values)
{
    values = values.first(std::min(values.size(), mostLookedAt));
    if (values.size() < fewestLevels)
        return std::nullopt;
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    const double range = *highest - *lowest;
    const double tolerance = latticeRounding * std::max(std::abs(*lowest), std::abs(*highest));
    const double smallest = std::max(finestStep * range, 100 * tolerance);
    if (!(range > 0) || !std::isfinite(range) || !(smallest > 0))
        return std::nullopt;
    const std::vector<double> steps = stepsBetween({values.begin(), values.end()}, tolerance);
    if (steps.size() + 1 < fewestLevels)
        return std::nullopt;
    double divisor = steps.front();
    for (const double step : steps) {
        double a = step;
        while (divisor >= smallest) {
            const double rest = remainderOf(a, divisor, 10 * tolerance);
            if (!(rest > 0))
                break;
            a = divisor;
            divisor = rest;
        }
        if (divisor < smallest)
            return std::nullopt;
    }
    return range / std::round(range / divisor);
}

} // namespace gripscope
