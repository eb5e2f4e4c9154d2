// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/axis_ticks.h"

#include "core/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

double roundStep(double span, int most)
{
    const double raw = span / std::max(1, most - 1);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double multiple : {1.0, 2.0, 5.0, 10.0})
        if (multiple * power >= raw * (1 - 1e-9))
            return multiple * power;
    return 10 * power;
}

} // namespace

QString AxisTicks::label(double value) const
{
    const int decimals = decimalsOf(step);
    const double clean = std::abs(value) < step / 1e6 ? 0 : value;
    return Words::number(clean, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

AxisTicks roundTicks(double low, double high, int most)
{
    AxisTicks ticks;
    if (!(high > low) || !std::isfinite(low) || !std::isfinite(high))
        return ticks;
    ticks.step = roundStep(high - low, std::max(2, most));
    const double first = std::ceil(low / ticks.step - 1e-6);
    const double last = std::floor(high / ticks.step + 1e-6);
    for (double i = first; i <= last; i += 1)
        ticks.values.push_back(i * ticks.step);
    return ticks;
}

double symmetricStep(double half)
{
    if (!(half > 0) || !std::isfinite(half))
        return 0;
    const double power = std::pow(10.0, std::floor(std::log10(half) + 1e-9));
    double step = power;
    for (const double multiple : {1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (multiple * power <= half * (1 + 1e-9))
            step = multiple * power;
    return step;
}

int decimalsOf(double step)
{
    if (!(step > 0))
        return 0;
    int decimals = 0;
    for (double scaled = step; decimals < 9 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled;
         ++decimals)
        scaled *= 10;
    return decimals;
}

AxisRange roundRange(double low, double high, double leastSpan)
{
    if (!std::isfinite(low) || !std::isfinite(high) || high < low)
        return {0, leastSpan > 0 ? leastSpan : 1};
    const double missing = std::max(0.0, leastSpan - (high - low));
    low -= missing / 2;
    high += missing / 2;
    const double step = roundStep(std::max(high - low, 1e-12) * 1.05, 6);
    // Noise around a round number does not ask for a whole step more.
    constexpr double slack = 0.04;
    return {std::floor(low / step + slack) * step, std::ceil(high / step - slack) * step};
}

} // namespace gripscope
