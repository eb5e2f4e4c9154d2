// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/channel_scale.h"

#include "core/signal/recording/units.h"
#include "ui/format/shown_unit.h"

#include <QCoreApplication>

#include <array>
#include <optional>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

QString ChannelScale::title(const QString& name) const
{
    if (unit.isEmpty())
        return QCoreApplication::translate("gripscope::ChannelScale", "%1 (as recorded)").arg(name);
    return u"%1 (%2)"_s.arg(name, unit);
}

namespace {

/// How much of SI one `unit` of force or of length is, and that SI unit.
std::optional<std::pair<QString, double>> siOf(const QString& unit)
{
    if (const std::optional<double> metres = metresPer(unit))
        return std::pair(u"m"_s, *metres);
    if (const std::optional<double> newtons = newtonsPer(unit))
        return std::pair(u"N"_s, *newtons);
    return std::nullopt;
}

} // namespace

ChannelScale tableScale(const QString& unit, double largest)
{
    using Step = std::pair<QString, double>; // unit and how much of SI it is, largest first
    static const std::array<Step, 4> lengths{
        Step{u"m"_s, 1}, {u"mm"_s, 1e-3}, {u"µm"_s, 1e-6}, {u"nm"_s, 1e-9}};
    static const std::array<Step, 4> forces{
        Step{u"kN"_s, 1e3}, {u"N"_s, 1}, {u"mN"_s, 1e-3}, {u"µN"_s, 1e-6}};
    if (unit == u"1")
        return {};
    const auto si = siOf(unit);
    if (!si || !(largest > 0))
        return {unit, 1};
    const auto& steps = si->first == u"m" ? lengths : forces;
    for (const Step& step : steps)
        if (largest * si->second >= step.second)
            return {step.first, si->second / step.second};
    return {steps.back().first, si->second / steps.back().second};
}

ChannelScale channelScale(const QString& unit, double largest)
{
    const auto si = siOf(unit);
    if (!si || displayUnit(si->first).unit == si->first)
        return tableScale(unit, largest);
    const ShownUnit shown = shownUnit(si->first, largest * si->second);
    return {shown.unit, si->second * shown.factor};
}

} // namespace gripscope
