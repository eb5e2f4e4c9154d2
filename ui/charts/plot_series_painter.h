// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QChart;
class QPainter;

namespace gripscope {

/// Paints the line and scatter series of a chart with two value axes, cut off at the plot area by geometry.
/// Charts cut them off by a clip, which SVG files do not get.
void paintSeries(QPainter& painter, const QChart& chart);

} // namespace gripscope
