// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/quantity_text.h"

#include "core/base/words.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Rounded to three significant digits first, so that 999.6 becomes 1 k and not 1000.
double rounded(double value)
{
    return QString::number(value, 'e', 2).toDouble();
}

} // namespace

Finding nameOf(MechanicalQuantity quantity)
{
    switch (quantity) {
    case MechanicalQuantity::Mass:
        return Words::say("Mass");
    case MechanicalQuantity::Damping:
        return Words::say("Damping");
    case MechanicalQuantity::Stiffness:
        return Words::say("Stiffness");
    case MechanicalQuantity::Force:
    case MechanicalQuantity::Length:
        break;
    }
    return {};
}

Finding shortNumber(double value)
{
    const double r = rounded(value);
    const double size = std::abs(r);
    if (size >= 1000 && size < 1e6)
        return Finding::number(r, 'f', 0);
    return Finding::number(r, 'g', 3);
}

} // namespace gripscope
