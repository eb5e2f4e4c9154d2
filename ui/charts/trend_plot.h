// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"
#include "core/recognition/types/type_model.h"
#include "core/recognition/verdict/verdict.h"
#include "ui/charts/axis_ticks.h"
#include "ui/charts/plot_export.h"
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
    int sign = 0;                        ///< which colour and shape, see paintTypeSign()
    std::vector<TypeInterval> intervals; ///< of m, b and k
    std::optional<GateIntervals> gate;   ///< beyond it in one of them a squeeze is called unknown
};

/// Squeezes over time or one after another, as much of them as is in view.
struct TrendContent {
    std::shared_ptr<const HistoryPoints> points;
    std::vector<TrendBand> bands;
    bool suspects = false, invalid = false; ///< whether there are such points
    bool byTime = true;                     ///< else one after another
    double low = 0, high = 1;               ///< in view: milliseconds since 1970, or places
    std::optional<std::size_t> selected;

    /// Of the `type`-th name of the points, whether that type is approved or not; -1: of none.
    [[nodiscard]] int sign(int type) const { return type < 0 ? -1 : points->places[std::size_t(type)]; }
    [[nodiscard]] bool gated() const;                     ///< some band has its gate
    [[nodiscard]] double across(std::size_t place) const; ///< where a point is along the axis
    [[nodiscard]] AxisRange whole() const;                ///< what holds all points, with a little air
    /// The points in view: from the first on, before the second.
    [[nodiscard]] std::pair<std::size_t, std::size_t> inView() const;
};

/// Bands of these points, in order of the enrolled types; everything in view. `gates`: of gateIntervals(),
/// which is no work for the screen's thread.
[[nodiscard]] TrendContent trendContent(std::shared_ptr<const HistoryPoints> points, const TypeModels& models,
                                        bool byTime, const std::vector<GateIntervals>& gates = {});

/// m, b or k of the squeezes: points with error bars in the shape and colour of their type; where there are
/// more than there is room for, what they span in each pixel column and their mean, and at the foot a tick
/// where one of them is in doubt. Behind them the intervals of the types, and their gates as lines. Paints on
/// whatever it is given, in any thread, and nothing outside of its box though there is no clip.
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
    void paintLevel(QPainter& painter, double value, const QPen& pen) const;
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
class TrendView : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit TrendView(QWidget* parent = nullptr);

    void setContent(TrendContent content);
    [[nodiscard]] const TrendContent& content() const { return m_content; }
    void setSelected(std::optional<std::size_t> place);

    [[nodiscard]] QString plotName() const override;
    [[nodiscard]] QString fileName() const override;
    /// With room for the legend, which the screen has beside it.
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    [[nodiscard]] PlotTable numbers() const override; ///< trendNumbers()

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
    QSize m_pictureSize;
    std::optional<QPoint> m_pressed, m_dragged;
};

} // namespace gripscope
