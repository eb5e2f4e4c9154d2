// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gripscope {

struct PlotPoint {
    double x = 0, y = 0;
    friend bool operator==(const PlotPoint&, const PlotPoint&) = default;
};

/// At most two points a column, the smallest and the largest y in the order they occur, so that a plot of any
/// length costs what its width costs and no peak is lost. x must not decrease. When there are at most 2 *
/// `columns` points they come back as they are. O(N).
[[nodiscard]] std::vector<PlotPoint> decimateMinMax(std::span<const double> x, std::span<const double> y,
                                                    std::size_t columns);

} // namespace gripscope
