// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/simulated_parts.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

const std::vector<SimulatedPart>& simulatedParts()
{
    static const std::vector<SimulatedPart> parts{
        {u"bottle"_s, u"Plastic bottle (simulated)"_s, {0.03, 35, 12'000}, 0.12, 0.06},
        {u"cup"_s, u"Plastic cup (simulated)"_s, {0.012, 15, 4'000}, 0.2, 0.12},
        {u"firm-foam"_s, u"Firm foam (simulated)"_s, {0.02, 25, 2'500}, 0.45, 0.04},
        {u"soft-foam"_s, u"Soft foam (simulated)"_s, {0.015, 12, 1'200}, 0.6, 0.09},
        {u"apple"_s, u"Apple (simulated)"_s, {0.09, 60, 18'000}, 0.25, 0.15},
        {u"tomato"_s, u"Tomato (simulated)"_s, {0.06, 30, 5'000}, 0.4, 0.2}};
    return parts;
}

const SimulatedPart* simulatedPart(const QString& key)
{
    const auto found = std::ranges::find(simulatedParts(), key, &SimulatedPart::key);
    return found != simulatedParts().end() ? &*found : nullptr;
}

} // namespace gripscope
