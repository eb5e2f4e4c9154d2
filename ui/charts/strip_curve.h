// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/live_history.h"

#include <QColor>
#include <QPointF>

#include <functional>

class QPainter;

namespace gripscope {

/// Where a point of a channel stands on the screen.
using StripPlace = std::function<QPointF(const PlotPoint&)>;

/// A measured channel: one thin line a stretch.
void paintMeasured(QPainter& painter, const std::vector<LiveHistory::Stretch>& stretches,
                   const StripPlace& place, const QColor& color, double thick);
/// A channel that was asked for: a wide band in steps, each value until the next, to lie below the line of
/// what was measured.
void paintCommanded(QPainter& painter, const std::vector<LiveHistory::Stretch>& stretches,
                    const StripPlace& place, const QColor& color, double thick);

} // namespace gripscope
