// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/channel_scale.h"

#include "core/signal/recording/units.h"
#include "ui/format/shown_unit.h"

#include <QCoreApplication>

#include <array>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

QString ChannelScale::title(const QString& name) const
{
    if (unit.isEmpty())
        return QCoreApplication::translate("gripscope::ChannelScale", "%1 (as recorded)").arg(name);
    return u"%1 (%2)"_s.arg(name, unit);
}

ChannelScale channelScale(const QString& unit, double largest)
{
    using Step = std::pair<QString, double>; // unit and how much of SI it is, largest first
    static const std::array<Step, 4> lengths{
        Step{u"m"_s, 1}, {u"mm"_s, 1e-3}, {u"µm"_s, 1e-6}, {u"nm"_s, 1e-9}};
    static const std::array<Step, 4> forces{
        Step{u"kN"_s, 1e3}, {u"N"_s, 1}, {u"mN"_s, 1e-3}, {u"µN"_s, 1e-6}};
    if (unit == u"1")
        return {};
    const std::optional<double> metres = metresPer(unit);
    const std::optional<double> newtons = newtonsPer(unit);
    if (!metres && !newtons)
        return {unit, 1};
    const double si = metres ? *metres : *newtons;
    const QString siUnit = metres ? u"m"_s : u"N"_s;
    if (displayUnit(siUnit).unit != siUnit) {
        const ShownUnit shown = shownUnit(siUnit, largest * si);
        return {shown.unit, si * shown.factor};
    }
    if (!(largest > 0))
        return {unit, 1};
    const auto& steps = metres ? lengths : forces;
    for (const Step& step : steps)
        if (largest * si >= step.second)
            return {step.first, si / step.second};
    return {steps.back().first, si / steps.back().second};
}

} // namespace gripscope
