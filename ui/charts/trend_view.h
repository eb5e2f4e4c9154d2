// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/trend_plot.h"

#include <QWidget>

namespace gripscope {

/// m, b and k of squeezes below each other. A click chooses a squeeze, dragging a stretch or the wheel zooms,
/// a double click or Home shows everything again, + and - zoom, arrows move.
class TrendView : public QWidget {
    Q_OBJECT
public:
    explicit TrendView(QWidget* parent = nullptr);

    void setContent(TrendContent content);
    [[nodiscard]] const TrendContent& content() const { return m_content; }
    void setSelected(std::optional<std::size_t> place);

    [[nodiscard]] QSize sizeHint() const override { return {640, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 240}; }

signals:
    void pointChosen(qsizetype place); ///< of the points

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF box(int parameter) const;
    [[nodiscard]] TrendPlot plot(int parameter) const;
    [[nodiscard]] bool empty() const;
    void show(double low, double high);
    void zoom(double around, double factor);

    TrendContent m_content;
    std::optional<QPoint> m_pressed, m_dragged;
};

} // namespace gripscope
