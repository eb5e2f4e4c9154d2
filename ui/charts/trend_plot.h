// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"
#include "core/recognition/types/type_model.h"
#include "ui/charts/axis_ticks.h"
#include "ui/format/shown_unit.h"
#include "ui/theme/theme.h"

#include <QRectF>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QPainter;

namespace gripscope {

/// Where the squeezes of an enrolled type lie.
struct TrendBand {
    QString type;
    int sign = 0; ///< which colour and shape, see paintTypeSign()
    std::array<TypeInterval, 3> intervals;
};

/// Squeezes over time or one after another, as much of them as is in view.
struct TrendContent {
    std::shared_ptr<const HistoryPoints> points;
    std::vector<int> signs; ///< of the types of `points`
    std::vector<TrendBand> bands;
    bool byTime = true;       ///< else one after another
    double low = 0, high = 1; ///< in view: milliseconds since 1970, or places
    std::optional<std::size_t> selected;

    [[nodiscard]] double across(std::size_t place) const; ///< where a point is along the axis
    [[nodiscard]] AxisRange whole() const;                ///< what holds all points, with a little air
    /// The points in view: from the first on, before the second.
    [[nodiscard]] std::pair<std::size_t, std::size_t> inView() const;
};

/// Signs and bands of these points, in order of the enrolled types; everything in view.
[[nodiscard]] TrendContent trendContent(std::shared_ptr<const HistoryPoints> points, const TypeModels& models,
                                        bool byTime);

/// A type's own sign, about `size` pixels across; -1: of no type.
void paintTypeSign(QPainter& painter, int sign, QPointF at, double size, const ThemeTokens& tokens);
/// The signs with the names of their types in a row, as many as `box` has room for.
void paintTypeLegend(QPainter& painter, const TrendContent& content, const QRectF& box,
                     const ThemeTokens& tokens);

/// m, b or k of the squeezes: points with error bars in the shape and colour of their type; where there are
/// more than there is room for, what they span in each pixel column and their mean. Behind them the intervals
/// of the types. Paints on whatever it is given, in any thread.
class TrendPlot {
public:
    /// `parameter`: 0, 1 or 2 for m, b, k.
    TrendPlot(const TrendContent& content, int parameter, const QRectF& box, bool withAxis);

    void paint(QPainter& painter, const ThemeTokens& tokens) const;
    [[nodiscard]] const QRectF& area() const { return m_area; }
    [[nodiscard]] double valueAt(double x) const; ///< along the axis, from pixels
    /// The point that is nearest to a place, where one is near.
    [[nodiscard]] std::optional<std::size_t> pointAt(QPointF at) const;

private:
    [[nodiscard]] double number(std::size_t place) const; ///< in the unit shown
    [[nodiscard]] double error(std::size_t place) const;  ///< half width of the 95 % interval
    [[nodiscard]] QPointF position(std::size_t place) const;
    [[nodiscard]] double height(double value) const;
    [[nodiscard]] bool crowded() const;
    void findRange();
    void paintFrame(QPainter& painter, const ThemeTokens& tokens) const;
    void paintAxis(QPainter& painter, const ThemeTokens& tokens) const;
    void paintBands(QPainter& painter, const ThemeTokens& tokens) const;
    void paintPoints(QPainter& painter, const ThemeTokens& tokens) const;
    void paintColumns(QPainter& painter, const ThemeTokens& tokens) const;

    const TrendContent& m_content;
    int m_parameter;
    QRectF m_box, m_area;
    bool m_withAxis;
    ShownUnit m_unit;
    AxisRange m_range;
};

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
