// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/series_model.h"

#include "core/identification/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gripscope {

namespace {

constexpr std::size_t largestOrder = 20;

/// r[lag] = mean of e[t] e[t - lag], in units of `scale`.
std::vector<double> autocovariances(std::span<const double> series, std::size_t lags, double scale)
{
    const auto count = static_cast<double>(series.size());
    std::vector<double> r(lags + 1, 0.0);
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        for (std::size_t i = lag; i < series.size(); ++i)
            r[lag] += (series[i] / scale) * (series[i - lag] / scale) / count;
    }
    return r;
}

} // namespace

std::optional<SeriesModel> autoregressiveModel(std::span<const double> series)
{
    if (series.empty() || !allFinite(series))
        return std::nullopt;
    const double scale = powerOfTwoScale(series);
    const auto count = static_cast<double>(series.size());
    const std::size_t orders = std::min(largestOrder, series.size() / 10);
    const std::vector<double> r = autocovariances(series, orders, scale);
    double variance = r[0];
    if (!(variance > 0))
        return std::nullopt;
    SeriesModel best;
    double bestVariance = variance;
    double bestCriterion = count * std::log(variance);
    std::vector<double> a;
    for (std::size_t order = 1; order <= orders; ++order) {
        double reflection = r[order];
        for (std::size_t i = 0; i < a.size(); ++i)
            reflection -= a[i] * r[order - 1 - i];
        reflection /= variance;
        std::vector<double> next(a);
        for (std::size_t i = 0; i < a.size(); ++i)
            next[i] -= reflection * a[a.size() - 1 - i];
        next.push_back(reflection);
        a = std::move(next);
        variance *= 1 - reflection * reflection;
        if (!(variance > 0))
            break;
        const double criterion = count * std::log(variance) + static_cast<double>(order) * std::log(count);
        if (criterion < bestCriterion) {
            bestCriterion = criterion;
            bestVariance = variance;
            best.coefficients = a;
        }
    }
    best.logLikelihood =
        -count / 2 * (std::log(2 * std::numbers::pi * bestVariance) + 1) - count * std::log(scale);
    return std::isfinite(best.logLikelihood) ? std::optional(best) : std::nullopt;
}

} // namespace gripscope
