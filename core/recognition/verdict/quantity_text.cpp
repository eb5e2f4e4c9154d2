// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/quantity_text.h"

#include "core/base/words.h"
#include "core/recognition/types/quantity_name.h"

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

Finding nameOf(TypeQuantity quantity)
{
    switch (quantity) {
    case TypeQuantity::Mass:
        return Words::say("Mass");
    case TypeQuantity::Damping:
        return Words::say("Damping");
    case TypeQuantity::Stiffness:
        return Words::say("Stiffness");
    case TypeQuantity::RelaxingShare:
    case TypeQuantity::RelaxationTime:
    case TypeQuantity::Friction:
        return nameWithin(quantity).capitalized();
    }
    return {};
}

Finding valueOf(TypeQuantity quantity, double si)
{
    switch (quantity) {
    case TypeQuantity::Mass:
    case TypeQuantity::Damping:
    case TypeQuantity::Stiffness:
        return Finding::quantity(MechanicalQuantity(quantity), si);
    case TypeQuantity::RelaxingShare:
        break;
    case TypeQuantity::RelaxationTime:
        return shortNumber(si) + u" s"_s;
    case TypeQuantity::Friction:
        return Finding::quantity(MechanicalQuantity::Force, si);
    }
    return shortNumber(si);
}

Finding listed(const QuantitySpace& space)
{
    Findings names;
    for (const TypeQuantity quantity : space.quantities)
        names.push_back(nameWithin(quantity));
    if (names.size() < 2)
        return names.empty() ? Finding() : names.front();
    const Finding last = names.back();
    names.pop_back();
    return Words::say("%1 and %2").arg(Finding::joined(names, u", "_s), last);
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
