// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/channel_quantity.h"

#include "core/signal/recording/units.h"

namespace gripscope {

Finding channelQuantity(MechanicalQuantity quantity, double value, const QString& unit)
{
    const std::optional<double> si =
        quantity == MechanicalQuantity::Length ? metresPer(unit) : newtonsPer(unit);
    if (si)
        return Finding::quantity(quantity, value * *si);
    constexpr int digits = 4;
    const Finding number = Finding::number(value, 'g', digits);
    return unit == QLatin1String("1") ? number : number + Finding(u' ' + unit);
}

} // namespace gripscope
