// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/quantity_text.h"

#include "core/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString baseUnit(MechanicalQuantity quantity)
{
    switch (quantity) {
    case MechanicalQuantity::Mass:
        return u"g"_s;
    case MechanicalQuantity::Damping:
        return u"N s/m"_s;
    case MechanicalQuantity::Stiffness:
        return u"N/m"_s;
    }
    return {};
}

/// Rounded to three significant digits first, so that 999.6 becomes 1 k and not 1000.
double rounded(double value)
{
    return QString::number(value, 'e', 2).toDouble();
}

} // namespace

QString nameOf(MechanicalQuantity quantity)
{
    switch (quantity) {
    case MechanicalQuantity::Mass:
        return Words::tr("Mass");
    case MechanicalQuantity::Damping:
        return Words::tr("Damping");
    case MechanicalQuantity::Stiffness:
        return Words::tr("Stiffness");
    }
    return {};
}

QString shortNumber(double value)
{
    const double r = rounded(value);
    const double size = std::abs(r);
    if (size >= 1000 && size < 1e6)
        return Words::number(r, 'f', 0);
    return Words::number(r, 'g', 3);
}

QString quantityText(MechanicalQuantity quantity, double siValue)
{
    static constexpr const char16_t* prefixes[] = {u"n", u"\u00b5", u"m", u"", u"k", u"M", u"G"};
    const double value = rounded(quantity == MechanicalQuantity::Mass ? siValue * 1000 : siValue);
    int thousands = 0;
    if (std::isfinite(value) && value != 0)
        thousands = std::clamp(int(std::floor(std::log10(std::abs(value)) / 3)), -3, 3);
    const QString prefix = QString::fromUtf16(prefixes[thousands + 3]);
    return u"%1 %2%3"_s.arg(shortNumber(value / std::pow(1000.0, thousands)), prefix, baseUnit(quantity));
}

} // namespace gripscope
