// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/robust_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscope {

double quantile(std::span<const double> values, double probability)
{
    if (values.empty())
        return 0;
    std::vector<double> sorted(values.begin(), values.end());
    const double last = static_cast<double>(sorted.size() - 1);
    const auto at = static_cast<std::ptrdiff_t>(std::llround(std::clamp(probability, 0.0, 1.0) * last));
    std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
    return sorted[static_cast<std::size_t>(at)];
}

double whiteNoiseDeviation(std::span<const double> values)
{
    constexpr std::size_t fewest = 8;
    if (values.size() < fewest)
        return 0;
    std::vector<double> differences(values.size() - 3);
    for (std::size_t i = 0; i < differences.size(); ++i) {
        // Halves keep the sum of the largest numbers finite.
        const double outer = values[i + 3] / 2 - values[i] / 2;
        const double inner = values[i + 2] / 2 - values[i + 1] / 2;
        differences[i] = std::abs(outer - 3 * inner);
    }
    const double median = quantile(differences, 0.5);
    constexpr double gaussianMedian = 0.6744897501960817;
    const double deviation = 2 * (median / (gaussianMedian * std::sqrt(20.0)));
    return std::isfinite(deviation) ? deviation : 0;
}

} // namespace gripscope
