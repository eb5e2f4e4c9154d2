// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/instrument_range.h"

#include <cmath>

namespace gripscope {

QuantityRange InstrumentRange::of(TypeQuantity quantity) const
{
    switch (quantity) {
    case TypeQuantity::Mass:
        return {lowest.m, highest.m};
    case TypeQuantity::Damping:
        return {lowest.b, highest.b};
    case TypeQuantity::Stiffness:
        return {lowest.k, highest.k};
    case TypeQuantity::RelaxingShare:
        return relaxingShare;
    case TypeQuantity::RelaxationTime:
        return relaxationTime;
    case TypeQuantity::Friction:
        return friction;
    }
    return {};
}

std::optional<double> InstrumentRange::logVolume(const QuantitySpace& space) const
{
    if (space.quantities.empty())
        return {};
    double volume = 1;
    for (const TypeQuantity quantity : space.quantities) {
        const QuantityRange range = of(quantity);
        if (!(range.lowest > 0 && range.highest > range.lowest && std::isfinite(range.highest)))
            return {};
        volume *= std::log(range.highest) - std::log(range.lowest);
    }
    return volume;
}

} // namespace gripscope
