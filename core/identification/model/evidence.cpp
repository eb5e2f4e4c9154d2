// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/evidence.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gripscope {

bool isDecisivelyWorse(const Estimate& estimate, const Estimate& other, double positionStep)
{
    constexpr double rounding = 1e-12; // of the positions
    const std::vector<double>& x = estimate.simulated;
    const double size = std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
    const auto count = static_cast<double>(other.residual.size());
    const double least = std::max(rounding * rounding * size, count * positionStep * positionStep / 12);
    const auto squares = [least](const Estimate& one) { return std::max(one.residuals.sse, least); };
    const double gain = count * std::log(squares(estimate) / squares(other));
    const double unknowns = estimate.residuals.degreesOfFreedom - other.residuals.degreesOfFreedom;
    return !(gain - unknowns * std::log(count) <= decisiveDelta);
}

} // namespace gripscope
