// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// How a channel is shown: in the multiple of its unit that keeps its numbers between 1 and 1000.
struct ChannelScale {
    QString unit;                                           ///< empty: as recorded, the source names none
    double factor = 1;                                      ///< shown number = recorded number * factor
    [[nodiscard]] QString title(const QString& name) const; ///< "Position (mm)"
};
/// `largest`: the largest magnitude to be shown. Units of force and length that core/signal/recording/units.h
/// knows; others stay as they are.
[[nodiscard]] ChannelScale channelScale(const QString& unit, double largest);
/// The same for tables that programs read: metric, whatever the person reads.
[[nodiscard]] ChannelScale tableScale(const QString& unit, double largest);

} // namespace gripscope
