// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/channel_curve.h"

#include <utility>

namespace gripscope {

namespace {

std::shared_ptr<const std::vector<double>> timesFactor(const std::vector<double>& values, double factor)
{
    auto result = std::make_shared<std::vector<double>>(values);
    for (double& value : *result)
        value *= factor;
    return result;
}

} // namespace

ChannelScales::ChannelScales(const QString& unit, double largest)
    : shown(channelScale(unit, largest)), table(tableScale(unit, largest))
{
}

PlotCurve channelCurve(const QString& name, CurveRole role, std::shared_ptr<const std::vector<double>> time_s,
                       const std::vector<double>& values, const ChannelScales& scales, const QString& column)
{
    PlotCurve curve{name, role, std::move(time_s), timesFactor(values, scales.shown.factor),
                    scales.table.title(column)};
    if (scales.table.unit != scales.shown.unit)
        curve.table = timesFactor(values, scales.table.factor);
    return curve;
}

} // namespace gripscope
