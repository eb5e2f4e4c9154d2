// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shown_unit.h"

namespace gripscope {

using namespace Qt::StringLiterals;

ShownUnit shownUnit(const QString& unit, double largest)
{
    if (unit == u"1")
        return {QString(), 1};
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
