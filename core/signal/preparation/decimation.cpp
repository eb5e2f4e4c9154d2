// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/decimation.h"

#include <algorithm>

namespace gripscope {

std::vector<PlotPoint> decimateMinMax(std::span<const double> x, std::span<const double> y,
                                      std::size_t columns)
{
    const std::size_t n = std::min(x.size(), y.size());
    std::vector<PlotPoint> points;
    if (n <= 2 * columns || columns == 0) {
        points.reserve(n);
        for (std::size_t i = 0; i < n; ++i)
            points.push_back({x[i], y[i]});
        return points;
    }
    points.reserve(2 * columns);
    for (std::size_t column = 0; column < columns; ++column) {
        const std::size_t first = column * n / columns;
        const std::size_t last = (column + 1) * n / columns;
        std::size_t low = first;
        std::size_t high = first;
        for (std::size_t i = first; i < last; ++i) {
            if (y[i] < y[low])
                low = i;
            if (y[i] > y[high])
                high = i;
        }
        const auto [early, late] = std::minmax(low, high);
        points.push_back({x[early], y[early]});
        if (late != early)
            points.push_back({x[late], y[late]});
    }
    return points;
}

} // namespace gripscope
