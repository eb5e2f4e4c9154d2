// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/two_sided_interval.h"

#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

TwoSidedInterval intervalOverDeviation(double index, double degreesOfFreedom, double confidence)
{
    const double beyond = (1 - confidence) / 2;
    const double one = index * std::sqrt(chiSquaredQuantile(beyond, degreesOfFreedom) / degreesOfFreedom);
    const double other =
        index * std::sqrt(chiSquaredQuantileAbove(beyond, degreesOfFreedom) / degreesOfFreedom);
    return {std::min(one, other), std::max(one, other)};
}

} // namespace gripscope
