// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/display_units.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

// One by one: of both at once not every compiler makes a plain load.
std::atomic<DisplayUnits::Force> chosenForce{DisplayUnits().force};
std::atomic<DisplayUnits::Length> chosenLength{DisplayUnits().length};

constexpr double kilogramsPerPound = 0.45359237;
constexpr double metresPerMillimetre = 1e-3;

/// How an SI unit is made of force, length and time; the mass stands for itself.
struct UnitParts {
    const char16_t* si;
    int force, length;
    const char16_t* time;
};
constexpr std::array<UnitParts, 5> unitParts{{{u"N", 1, 0, u""},
                                              {u"m", 0, 1, u""},
                                              {u"N s/m", 1, -1, u" s"},
                                              {u"N/m", 1, -1, u""},
                                              {u"N/m\u00B3", 1, -3, u""}}};

constexpr std::array<const char16_t*, 5> siUnitOf{u"kg", u"N s/m", u"N/m", u"N", u"m"};

ShownUnit forceUnit(DisplayUnits units)
{
    switch (units.force) {
    case DisplayUnits::Force::Newton:
        break;
    case DisplayUnits::Force::PoundForce:
        return {u"lbf"_s, newtonsPerPoundForce};
    case DisplayUnits::Force::KilogramForce:
        return {u"kgf"_s, newtonsPerKilogramForce};
    }
    return {u"N"_s, 1};
}

/// Stiffness in lbf/mm or kgf/mm is usual where the length is metric; per metre only with newtons.
ShownUnit lengthUnit(DisplayUnits units, bool below)
{
    if (units.length == DisplayUnits::Length::Inch)
        return {u"in"_s, metresPerInch};
    if (below && units.force != DisplayUnits::Force::Newton)
        return {u"mm"_s, metresPerMillimetre};
    return {u"m"_s, 1};
}

ShownUnit withFactor(const QString& unit, double siPerUnit)
{
    return {unit, 1 / siPerUnit};
}

ShownUnit composed(const UnitParts& parts, DisplayUnits units)
{
    const ShownUnit force = forceUnit(units);
    const ShownUnit length = lengthUnit(units, parts.length < 0);
    if (parts.force == 0)
        return withFactor(length.unit, length.factor);
    if (parts.length == 0)
        return withFactor(force.unit, force.factor);
    const QString cubed = parts.length == -3 ? u"\u00B3"_s : QString();
    return withFactor(force.unit + QString::fromUtf16(parts.time) + u'/' + length.unit + cubed,
                      force.factor * std::pow(length.factor, parts.length));
}

/// Three significant digits, rounded before a prefix is chosen: 999.6 becomes 1 k and not 1000.
double toThreeDigits(double value)
{
    return QString::number(value, 'e', 2).toDouble();
}

QString parameterInWords(MechanicalQuantity quantity, double si)
{
    static constexpr const char16_t* prefixes[] = {u"n", u"\u00b5", u"m", u"", u"k", u"M", u"G"};
    const bool mass = quantity == MechanicalQuantity::Mass;
    const double value = toThreeDigits(mass ? si * 1000 : si);
    int thousands = 0;
    if (std::isfinite(value) && value != 0)
        thousands = std::clamp(int(std::floor(std::log10(std::abs(value)) / 3)), -3, 3);
    const QString unit = mass ? u"g"_s : QString::fromUtf16(siUnitOf[std::size_t(quantity)]);
    const double number = toThreeDigits(value / std::pow(1000.0, thousands));
    const bool whole = std::abs(number) >= 1000 && std::abs(number) < 1e6; // beyond the prefixes: no exponent
    return QString::number(number, whole ? 'f' : 'g', whole ? 0 : 3) + u' ' +
           QString::fromUtf16(prefixes[thousands + 3]) + unit;
}

} // namespace

DisplayUnits DisplayUnits::current()
{
    return {chosenForce.load(), chosenLength.load()};
}

void DisplayUnits::choose(DisplayUnits units)
{
    chosenForce.store(units.force);
    chosenLength.store(units.length);
}

ShownUnit displayUnit(const QString& siUnit, DisplayUnits units)
{
    if (siUnit == u"kg")
        return units.force == DisplayUnits::Force::PoundForce ? withFactor(u"lb"_s, kilogramsPerPound)
                                                              : ShownUnit{siUnit, 1};
    const auto* const parts = std::find_if(unitParts.begin(), unitParts.end(), [&](const UnitParts& known) {
        return siUnit == QStringView(known.si);
    });
    return parts == unitParts.end() || units == DisplayUnits() ? ShownUnit{siUnit, 1}
                                                               : composed(*parts, units);
}

ShownUnit fieldUnit(MechanicalQuantity quantity, DisplayUnits units)
{
    const QString si = QString::fromUtf16(siUnitOf[std::size_t(quantity)]);
    const ShownUnit shown = displayUnit(si, units);
    if (shown.unit == u"kg")
        return {u"g"_s, 1e3};
    if (shown.unit == u"N/m")
        return {u"kN/m"_s, 1e-3};
    if (shown.unit == u"m")
        return {u"mm"_s, 1e3};
    return shown;
}

QString quantityInWords(MechanicalQuantity quantity, double si, DisplayUnits units)
{
    const bool parameter = quantity != MechanicalQuantity::Force && quantity != MechanicalQuantity::Length;
    const QString siUnit = QString::fromUtf16(siUnitOf[std::size_t(quantity)]);
    if (parameter && displayUnit(siUnit, units).unit == siUnit)
        return parameterInWords(quantity, si);
    const ShownUnit shown = fieldUnit(quantity, units);
    return QString::number(si * shown.factor, 'g', parameter ? 3 : 4) + u' ' + shown.unit;
}

} // namespace gripscope
