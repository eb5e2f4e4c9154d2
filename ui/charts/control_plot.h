// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/axis_ticks.h"
#include "ui/charts/control_series.h"
#include "ui/theme/theme.h"

#include <QRectF>

class QPainter;

namespace gripscope {

/// Points in view, from the first on, before the last.
struct PointsInView {
    std::size_t first = 0, last = 0;
    [[nodiscard]] std::size_t count() const { return last - first; }
    friend bool operator==(const PointsInView&, const PointsInView&) = default;
};

/// One control chart: centre line, limits with their values, points joined, signals marked by a diamond;
/// where there are more points than there is room for, what they span in each pixel column. Fixed limits: the
/// inspections that they come from lie on a tinted ground. Paints on whatever it is given, in any thread,
/// nothing outside of its box.
class ControlPlot {
public:
    ControlPlot(const ProcessPicture& picture, const ControlPanel& panel, const PointsInView& view,
                const QRectF& box, bool withAxis);

    void paint(QPainter& painter, const ThemeTokens& tokens) const;
    [[nodiscard]] const QRectF& area() const { return m_area; }
    [[nodiscard]] const ControlSeries& series() const { return m_series; }
    /// The point that is nearest to a place, where one is near.
    [[nodiscard]] std::optional<std::size_t> pointAt(QPointF at) const;
    [[nodiscard]] double placeAt(double x) const; ///< along the axis, in points
    [[nodiscard]] QPointF position(std::size_t point) const;

private:
    [[nodiscard]] double height(double value) const;
    [[nodiscard]] double across(double point) const;
    /// The first in view with that number or a higher one: they ascend but for squeezes of several stations.
    [[nodiscard]] std::size_t pointOf(qint64 number) const;
    [[nodiscard]] std::vector<std::size_t> numberedPoints(std::size_t most) const;
    [[nodiscard]] bool crowded() const;
    [[nodiscard]] std::size_t columns() const;
    [[nodiscard]] std::size_t columnBegin(std::size_t column) const;
    void findRange();
    void paintGround(QPainter& painter, const ThemeTokens& tokens) const;
    void paintFrame(QPainter& painter, const ThemeTokens& tokens) const;
    void paintNumbers(QPainter& painter, const ThemeTokens& tokens) const;
    void paintLimitValues(QPainter& painter, const ThemeTokens& tokens, double step) const;
    void paintLimits(QPainter& painter, const ThemeTokens& tokens) const;
    void paintPoints(QPainter& painter, const ThemeTokens& tokens) const;
    void paintColumns(QPainter& painter, const ThemeTokens& tokens) const;
    void paintSignal(QPainter& painter, QPointF at, const ThemeTokens& tokens) const;

    const ProcessPicture& m_picture;
    ControlSeries m_series;
    PointsInView m_view;
    QRectF m_box, m_area;
    bool m_withAxis;
    AxisRange m_range;
};

} // namespace gripscope
