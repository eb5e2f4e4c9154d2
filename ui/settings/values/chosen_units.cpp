// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/values/chosen_units.h"

#include "ui/settings/values/settings.h"

namespace gripscope {

namespace {

template <typename Unit, std::size_t N>
Unit named(const std::array<UnitChoice<Unit>, N>& choices, const QString& name)
{
    for (const UnitChoice<Unit>& one : choices)
        if (name == QLatin1String(one.name))
            return one.unit;
    return choices.front().unit;
}

} // namespace

DisplayUnits chosenUnits(const Settings& settings)
{
    return {named(forceUnitChoices, settings.get(setting::forceUnit)),
            named(lengthUnitChoices, settings.get(setting::lengthUnit))};
}

} // namespace gripscope
