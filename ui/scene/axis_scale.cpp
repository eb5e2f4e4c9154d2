// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/axis_scale.h"

#include "ui/models/shown_unit.h"
#include "ui/widgets/axis_ticks.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

AxisScale axisScale(const QString& name, const QString& unit, double low, double high, int most)
{
    if (!(high > low)) {
        const double middle = std::isfinite(low) && std::isfinite(high) ? (low + high) / 2 : 0.5;
        const double half = middle != 0 ? std::abs(middle) / 10 : 0.5;
        low = middle - half;
        high = middle + half;
    }
    AxisScale scale;
    scale.name = name;
    const ShownUnit shown = shownUnit(unit, std::max(std::abs(low), std::abs(high)));
    scale.unit = shown.unit;
    scale.factor = shown.factor;
    // Steps are round in the unit shown, not in the one stored.
    const double step = roundTicks(low * shown.factor, high * shown.factor, most + 1).step;
    const double first = std::floor(low * shown.factor / step + 1e-9);
    const double last = std::ceil(high * shown.factor / step - 1e-9);
    scale.step = step / shown.factor;
    scale.low = first * scale.step;
    scale.high = last * scale.step;
    for (double n = first; n <= last + 0.5; ++n)
        scale.ticks.push_back(n * scale.step);
    return scale;
}

QString AxisScale::title() const
{
    if (unit.isEmpty())
        return QCoreApplication::translate("gripscope::AxisScale", "%1 (as printed)").arg(name);
    return u"%1 (%2)"_s.arg(name, unit);
}

QString AxisScale::tickText(double value) const
{
    return AxisTicks{{}, step * factor}.label(value * factor);
}

QString AxisScale::valueText(double value) const
{
    const QString number = QLocale().toString(value * factor, 'g', 4);
    return unit.isEmpty() ? number : number + QChar::Nbsp + unit;
}

QString AxisScale::numberText(double value) const
{
    return QLocale().toString(value * factor, 'g', 3);
}

} // namespace gripscope
