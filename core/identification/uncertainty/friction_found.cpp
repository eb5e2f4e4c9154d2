// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/friction_found.h"

#include <cmath>
#include <numbers>

namespace gripscope {

FrictionFound together(const FrictionFound& found, const std::optional<GripperFriction>& known)
{
    constexpr double refutedBeyond = 4; // standard errors
    if (!known || !(known->standardError > 0))
        return found;
    const double spread = std::hypot(found.deviation, known->standardError);
    if (std::abs(found.value - known->value) > refutedBeyond * spread)
        return found;
    const double weight = std::pow(found.deviation / spread, 2); // of what is known
    return {found.value + weight * (known->value - found.value),
            found.deviation * known->standardError / spread};
}

double secondMoment(const FrictionFound& f)
{
    const double lowest = -f.value / f.deviation;
    const double density = std::exp(-lowest * lowest / 2) / std::sqrt(2 * std::numbers::pi);
    const double hazard = density / (std::erfc(lowest / std::numbers::sqrt2) / 2);
    return f.value * f.value + f.deviation * f.deviation + f.value * f.deviation * hazard;
}

} // namespace gripscope
