// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/feed/live_history.h"

#include <QList>
#include <QPointF>
#include <QRectF>

#include <functional>
#include <vector>

class QColor;
class QPainter;

namespace gripscope {

/// Where a value of a channel stands on the screen.
using StripPlace = std::function<QPointF(const PlotPoint&)>;

/// A stretch as it is painted: a line, and what lies behind it.
struct StripCurve {
    QList<QPointF> line;
    /// From the lowest to the highest, where several columns side by side reach over many pixels each: a line
    /// from end to end would only be a block there, so it is the mean.
    QList<QRectF> envelope;
};
[[nodiscard]] std::vector<StripCurve> stripCurves(const std::vector<LiveHistory::Stretch>& stretches,
                                                  const StripPlace& place);

void paintEnvelopes(QPainter& painter, const std::vector<StripCurve>& curves, const QColor& color);
/// A channel that was asked for: a wide band in steps, each value until the next.
void paintCommanded(QPainter& painter, const std::vector<StripCurve>& curves, const QColor& color,
                    double thick);
/// A measured channel: one thin line a stretch.
void paintMeasured(QPainter& painter, const std::vector<StripCurve>& curves, const QColor& color,
                   double thick);

} // namespace gripscope
