// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/fit_plots.h"
#include "ui/format/channel_scale.h"

namespace gripscope {

/// How the numbers of a channel are drawn, and how they are written into tables.
struct ChannelScales {
    ChannelScales(const QString& unit, double largest);
    ChannelScale shown, table;
};

/// `values` in the channel's unit over `time_s`; `column` says what they are, without a unit.
[[nodiscard]] PlotCurve channelCurve(const QString& name, CurveRole role,
                                     std::shared_ptr<const std::vector<double>> time_s,
                                     const std::vector<double>& values, const ChannelScales& scales,
                                     const QString& column);

} // namespace gripscope
