// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shown_unit.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A power of a thousand in front of a unit that takes no prefix: "×10⁻⁶ N/mm".
ShownUnit withPower(const QString& unit, double largest)
{
    const int exponent = 3 * int(std::floor(std::log10(largest) / 3));
    QString power = QString::number(exponent);
    for (QChar& digit : power) {
        static const QString raised = u"⁰¹²³⁴⁵⁶⁷⁸⁹"_s;
        digit = digit == u'-' ? QChar(0x207B) : raised[digit.digitValue()];
    }
    const QString text = u"×10%1"_s.arg(power);
    return {unit.isEmpty() ? text : text + u' ' + unit, std::pow(10.0, -exponent)};
}

} // namespace

ShownUnit shownUnit(const QString& unit, double largest)
{
    const QString named = unit == u"1" ? QString() : unit;
    const bool prefixed = unit == u"kg" || unit == u"N/m" || unit == u"N s/m";
    if (!prefixed && std::isfinite(largest) && ((largest > 0 && largest < 1e-3) || largest >= 1e6))
        return withPower(named, largest);
    if (named.isEmpty())
        return {named, 1};
    if (unit == u"kg" && largest < 1)
        return {u"g"_s, 1e3};
    if (unit == u"N/m" && largest >= 1e6)
        return {u"MN/m"_s, 1e-6};
    if (unit == u"N/m" && largest >= 1e3)
        return {u"kN/m"_s, 1e-3};
    if (unit == u"N s/m" && largest >= 1e4)
        return {u"kN s/m"_s, 1e-3};
    return {unit, 1};
}

} // namespace gripscope
