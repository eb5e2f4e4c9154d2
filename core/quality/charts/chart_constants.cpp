// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/chart_constants.h"

#include "core/math/normal_spread.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

ChartConstants chartConstants(int size)
{
    const int n = std::max(2, size);
    const RangeMoments range = rangeMoments(n);
    return {n, range.d2, range.d3, deviationBias(n - 1)};
}

double ChartConstants::A() const
{
    return 3 / std::sqrt(double(size));
}

double ChartConstants::B5() const
{
    return std::max(0.0, c4 - 3 * std::sqrt(1 - c4 * c4));
}

double ChartConstants::B6() const
{
    return c4 + 3 * std::sqrt(1 - c4 * c4);
}

double ChartConstants::D1() const
{
    return std::max(0.0, d2 - 3 * d3);
}

double ChartConstants::D2() const
{
    return d2 + 3 * d3;
}

} // namespace gripscope
