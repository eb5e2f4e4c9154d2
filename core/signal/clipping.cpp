// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/clipping.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr std::size_t shortestRun = 3;

std::size_t samplesInFastRuns(std::span<const double> values, double rail, double smallestJump)
{
    std::size_t total = 0;
    for (std::size_t i = 0; i < values.size();) {
        if (values[i] != rail) {
            ++i;
            continue;
        }
        const std::size_t first = i;
        while (i < values.size() && values[i] == rail)
            ++i;
        const bool fast = first > 0 && std::abs(rail - values[first - 1]) > smallestJump;
        if (i - first >= shortestRun && fast)
            total += i - first;
    }
    return total;
}

} // namespace

ClippedSamples clippedSamples(std::span<const double> values, double latticeStep)
{
    ClippedSamples clipped;
    if (values.empty())
        return clipped;
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    const double low = *lowest, high = *highest;
    const auto between = static_cast<std::size_t>(std::count_if(
        values.begin(), values.end(), [low, high](double value) { return value > low && value < high; }));
    if (2 * between < values.size())
        return clipped;
    const double smallestJump = std::max(1e-6 * (high - low), 2 * latticeStep);
    if (low != 0)
        clipped.atLowest = samplesInFastRuns(values, low, smallestJump);
    if (high != 0)
        clipped.atHighest = samplesInFastRuns(values, high, smallestJump);
    return clipped;
}

} // namespace gripscope
