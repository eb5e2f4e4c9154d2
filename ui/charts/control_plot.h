// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/axis_ticks.h"
#include "ui/charts/control_series.h"
#include "ui/charts/plot_export.h"
#include "ui/theme/theme.h"

#include <QRectF>
#include <QWidget>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

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

/// The panels of a picture below each other, alike but for the axis of the lowest.
void paintControlFigure(QPainter& painter, const ProcessPicture& picture,
                        const std::vector<ControlPanel>& panels, const QRectF& room,
                        const ThemeTokens& tokens);
/// A row a point: inspection, time, value, limits, rules that are broken, of each panel.
[[nodiscard]] PlotTable controlNumbers(const ProcessPicture& picture,
                                       const std::vector<ControlPanel>& panels);

/// Control charts on the screen. A click chooses a point, dragging a stretch or the wheel zooms, a double
/// click or Home shows everything again, + and - zoom, arrows move.
class ControlView : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit ControlView(QWidget* parent = nullptr);

    /// What is in view stays where the picture goes on; else all comes into view.
    void setPicture(std::shared_ptr<const ProcessPicture> picture, std::vector<ControlPanel> panels);
    [[nodiscard]] const std::vector<ControlPanel>& panels() const { return m_panels; }
    [[nodiscard]] const PointsInView& view() const { return m_view; }
    [[nodiscard]] bool showsAll() const;
    /// Numbers of the first and the last inspection in view; nothing where there is no point.
    [[nodiscard]] std::optional<std::pair<qint64, qint64>> numbersInView() const;
    void showPoint(std::size_t point); ///< brings it into view
    [[nodiscard]] ControlPlot plot(std::size_t panel) const;

    [[nodiscard]] QString plotName() const override;
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    [[nodiscard]] PlotTable numbers() const override;

    [[nodiscard]] QSize sizeHint() const override { return {640, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void rowChosen(quint32 row); ///< of the picture's values
    void viewChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] std::size_t points() const;
    [[nodiscard]] bool empty() const { return points() == 0; }
    void show(double first, double last);
    void showAll();
    void zoom(double around, double factor);
    void click(QPoint at);

    std::shared_ptr<const ProcessPicture> m_picture;
    std::vector<ControlPanel> m_panels;
    PointsInView m_view;
    QSize m_pictureSize;
    std::optional<QPoint> m_pressed, m_dragged;
};

} // namespace gripscope
