// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic/periodic_search.h"
#include "core/math/fit.h"
#include "core/math/fourier.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscope {

namespace {

constexpr std::size_t fewestStretchPeriods = 4;
/// Below this correlation a force does not repeat: noise that is not repeated has half the deviation of what
/// is.
constexpr double lowestCorrelation = 0.8;

/// Cut at one and a half times the range of the middle eight tenths, so that what comes before and after the
/// excitation does not outweigh it.
std::vector<double> cut(std::span<const double> values)
{
    std::vector<double> sorted(values.begin(), values.end());
    const auto quantile = [&](std::size_t twentieths) {
        const std::size_t index = sorted.size() * twentieths / 20;
        const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(index);
        std::nth_element(sorted.begin(), at, sorted.end());
        return *at;
    };
    const double low = quantile(2);
    const double high = quantile(18);
    const double reach = high / 4 - low / 4; // a quarter of the range beyond either end
    std::vector<double> out(values.begin(), values.end());
    for (double& value : out)
        value = std::clamp(value, low - reach, high + reach);
    return out;
}

/// The values over their largest magnitude, less the straight line through them.
std::vector<double> withoutTrend(std::span<const double> values)
{
    const double scale = powerOfTwoScale(values);
    const auto count = static_cast<double>(values.size());
    double mean = 0;
    double slope = 0;
    double spread = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double t = static_cast<double>(i) - (count - 1) / 2;
        mean += values[i] / scale / count;
        slope += t * (values[i] / scale);
        spread += t * t;
    }
    slope /= std::max(spread, 1.0);
    std::vector<double> out(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        out[i] = values[i] / scale - mean - slope * (static_cast<double>(i) - (count - 1) / 2);
    return out;
}

/// sum of squares of the first i values, for i = 0..n.
std::vector<double> energyUpTo(const std::vector<double>& values)
{
    std::vector<double> sums(values.size() + 1);
    for (std::size_t i = 0; i < values.size(); ++i)
        sums[i + 1] = sums[i] + values[i] * values[i];
    return sums;
}

/// 2 sum x[t] x[t + lag] / (sum x[t]^2 + sum x[t + lag]^2): 1 exactly when the values repeat.
std::vector<double> normalizedCorrelation(const std::vector<double>& values, std::size_t largestLag)
{
    std::vector<double> correlation = autocorrelation(values, largestLag);
    const std::vector<double> energy = energyUpTo(values);
    for (std::size_t lag = 0; lag < correlation.size(); ++lag) {
        const double both = energy[values.size() - lag] + energy.back() - energy[lag];
        correlation[lag] = both > 0 ? 2 * correlation[lag] / both : 0;
    }
    return correlation;
}

double correlationAt(const std::vector<double>& values, std::size_t lag)
{
    double product = 0;
    double energy = 0;
    for (std::size_t t = 0; t + lag < values.size(); ++t) {
        product += values[t] * values[t + lag];
        energy += values[t] * values[t] + values[t + lag] * values[t + lag];
    }
    return energy > 0 ? 2 * product / energy : 0;
}

/// Among the neighbours of `period`, the one whose multiple near the end of the record correlates best: a
/// distance of many periods tells a period that is off by one sample apart best.
std::size_t refined(const std::vector<double>& values, std::size_t period)
{
    std::size_t best = period;
    for (std::size_t multiple = 2; multiple * period <= values.size() * 3 / 4; multiple *= 2) {
        double highest = -2;
        const std::size_t centre = best;
        for (std::size_t candidate = centre - 1; candidate <= centre + 1; ++candidate) {
            const double correlation = correlationAt(values, multiple * candidate);
            // What is equal up to rounding does not move the period.
            if (correlation > highest + (candidate == centre ? -1e-12 : 1e-12)) {
                highest = correlation;
                best = candidate;
            }
        }
    }
    return best;
}

double medianShare(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::optional<std::size_t> findPeriod(std::span<const double> force)
{
    const std::size_t largestLag = force.size() / fewestStretchPeriods;
    if (largestLag < 4)
        return std::nullopt;
    const std::vector<double> values = withoutTrend(cut(force));
    const std::vector<double> correlation = normalizedCorrelation(values, largestLag);
    // Beyond the main lobe around lag 0.
    std::size_t first = 1;
    while (first <= largestLag && correlation[first] > lowestCorrelation / 2)
        ++first;
    const auto isPeak = [&](std::size_t lag) {
        return correlation[lag] >= correlation[lag - 1] &&
               (lag == largestLag || correlation[lag] >= correlation[lag + 1]);
    };
    double highest = 0;
    for (std::size_t lag = first; lag <= largestLag; ++lag)
        highest = std::max(highest, isPeak(lag) ? correlation[lag] : 0);
    if (highest < lowestCorrelation)
        return std::nullopt;
    // Multiples of the period correlate as well as the period itself, up to noise and drift.
    constexpr double rounding = 1e-9;
    const double enough = 1 - 2 * (1 - highest) - rounding;
    for (std::size_t lag = first; lag <= largestLag; ++lag) {
        if (correlation[lag] >= enough && isPeak(lag))
            return refined(values, lag);
    }
    return std::nullopt;
}

Window periodicStretch(std::span<const double> force, std::size_t period)
{
    if (period < 2 || force.size() / period < 2)
        return {};
    const std::vector<double> values = withoutTrend(force);
    std::vector<double> change(values.size() - period);
    for (std::size_t t = 0; t < change.size(); ++t)
        change[t] = values[t + period] - values[t];
    const std::vector<double> energy = energyUpTo(change);
    std::vector<double> overPeriod(change.size() - period + 1);
    for (std::size_t t = 0; t < overPeriod.size(); ++t)
        overPeriod[t] = energy[t + period] - energy[t];

    const double usual = medianShare(overPeriod);
    double mean = 0;
    for (const double value : values)
        mean += value * value / static_cast<double>(values.size());
    // Twice the variance is what two unrelated stretches differ by.
    const double unrelated = 2 * mean * static_cast<double>(period);
    if (!(usual < (1 - lowestCorrelation) * unrelated))
        return {};
    const double limit = std::max(4 * usual, 1e-3 * unrelated);
    Window best;
    for (std::size_t t = 0; t < overPeriod.size();) {
        const std::size_t begin = t;
        while (t < overPeriod.size() && overPeriod[t] <= limit)
            ++t;
        if (t > begin && t - begin > best.count)
            best = {begin, t - begin};
        t += t == begin ? 1 : 0;
    }
    return best.count == 0 ? Window{} : Window{best.first, best.count + 2 * period - 1};
}

} // namespace gripscope
