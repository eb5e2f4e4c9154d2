// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/shown_unit.h"

#include "core/base/finding.h"
#include "core/base/words.h"
#include "core/signal/recording/units.h"

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

/// Multiples of SI units that keep a column short, the largest first; below the last the unit itself.
struct Multiple {
    const char16_t *si, *shown;
    double least, factor;
};
constexpr Multiple multiples[] = {
    {u"N/m", u"MN/m", 1e6, 1e-6}, {u"N/m", u"kN/m", 1e3, 1e-3}, {u"N s/m", u"kN s/m", 1e4, 1e-3}};

} // namespace

ShownUnit shownUnit(const QString& unit, double largest)
{
    const QString named = unit == u"1" ? QString() : unit;
    const ShownUnit shown = displayUnit(named);
    if (shown.unit == u"kg")
        return largest < 1 ? ShownUnit{u"g"_s, 1e3} : shown;
    if (shown.unit == u"N/m" || shown.unit == u"N s/m") {
        for (const Multiple& multiple : multiples)
            if (shown.unit == QStringView(multiple.si) && largest >= multiple.least)
                return {QString::fromUtf16(multiple.shown), multiple.factor};
        return shown;
    }
    const double most = largest * shown.factor;
    if (!std::isfinite(most) || most <= 0 || (most >= 1e-3 && most < 1e6))
        return shown;
    const ShownUnit power = withPower(shown.unit, most);
    return {power.unit, power.factor * shown.factor};
}

ShownUnit readUnit(const QString& unit)
{
    const std::optional<double> newtons = newtonsPer(unit);
    const std::optional<double> si = newtons ? newtons : metresPer(unit);
    if (!si)
        return displayUnit(unit);
    const QString siUnit = newtons ? u"N"_s : u"m"_s;
    const ShownUnit shown = displayUnit(siUnit);
    return shown.unit == siUnit ? ShownUnit{unit, 1} : ShownUnit{shown.unit, shown.factor * *si};
}

ShownUnit cubicShownUnit(const QString& unit, double largest)
{
    const ShownUnit shown = displayUnit(unit);
    return shown.unit == u"N/m\u00B3" && largest >= 1e6 ? ShownUnit{u"N/mm\u00B3"_s, 1e-9} : shown;
}

QString forceText(double force_N)
{
    return Finding::quantity(MechanicalQuantity::Force, force_N).describe();
}

QString lengthText(double length_m)
{
    return Finding::quantity(MechanicalQuantity::Length, length_m).describe();
}

QString pushText(double bias_N, double peak_N)
{
    constexpr int digits = 4;
    return Words::number(bias_N * fieldUnit(MechanicalQuantity::Force).factor, 'g', digits) + u" ± "_s +
           forceText(peak_N);
}

} // namespace gripscope
