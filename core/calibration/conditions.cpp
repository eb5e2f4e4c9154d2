// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/conditions.h"

#include "core/base/words.h"
#include "core/signal/recording/units.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(LoadUnit unit)
{
    switch (unit) {
    case LoadUnit::Channel:
        break;
    case LoadUnit::Kilogram:
        return u"kg"_s;
    case LoadUnit::Pound:
        return u"lb"_s;
    }
    return u""_s; // not a null one, which a database would take for nothing
}

std::optional<LoadUnit> loadUnitFromString(const QString& text)
{
    for (const LoadUnit unit : {LoadUnit::Channel, LoadUnit::Kilogram, LoadUnit::Pound})
        if (toString(unit) == text)
            return unit;
    return std::nullopt;
}

std::optional<ShownUnit> massPerNewton(LoadUnit unit, double gravity)
{
    constexpr double kilogramsPerPound = 0.45359237; // exact
    switch (unit) {
    case LoadUnit::Channel:
        break;
    case LoadUnit::Kilogram:
        return ShownUnit{u"kg"_s, 1 / gravity};
    case LoadUnit::Pound:
        return ShownUnit{u"lb"_s, 1 / (gravity * kilogramsPerPound)};
    }
    return std::nullopt;
}

std::optional<ShownUnit> massPerLoad(LoadUnit unit, double gravity, const QString& channelUnit)
{
    std::optional<ShownUnit> mass = massPerNewton(unit, gravity);
    const std::optional<double> newtons = newtonsPer(channelUnit);
    if (!mass || !newtons)
        return std::nullopt;
    mass->factor *= *newtons;
    return mass;
}

QString toString(DecisionRule rule)
{
    return rule == DecisionRule::Guarded ? u"guarded"_s : u"simple"_s;
}

std::optional<DecisionRule> decisionRuleFromString(const QString& text)
{
    for (const DecisionRule rule : {DecisionRule::Guarded, DecisionRule::Simple})
        if (toString(rule) == text)
            return rule;
    return std::nullopt;
}

std::optional<Error> problemOf(const CalibrationConditions& conditions)
{
    const auto within = [](double value, double least, double most) {
        return value >= least && value <= most;
    };
    if (!within(conditions.gravity, leastGravity, mostGravity))
        return Error{ErrorCode::Usage,
                     {Words::say("Local gravity is %1 to %2 m/s² on the ground, not %3.")
                          .arg(leastGravity)
                          .arg(mostGravity)
                          .arg(conditions.gravity)}};
    if (conditions.ambient_C && !within(*conditions.ambient_C, leastAmbient_C, mostAmbient_C))
        return Error{ErrorCode::Usage,
                     {Words::say("An ambient temperature is %1 to %2 °C, not %3.")
                          .arg(leastAmbient_C)
                          .arg(mostAmbient_C)
                          .arg(*conditions.ambient_C)}};
    if (conditions.tolerance && !(*conditions.tolerance > 0 && *conditions.tolerance < 1e12))
        return Error{ErrorCode::Usage,
                     {Words::say("A tolerance is larger than zero, not %1.").arg(*conditions.tolerance)}};
    return std::nullopt;
}

} // namespace gripscope
