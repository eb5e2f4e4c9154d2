// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/control_plot.h"
#include "ui/charts/plot_export.h"

#include <QWidget>

namespace gripscope {

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
