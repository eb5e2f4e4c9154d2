// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/axis_ticks.h"
#include "ui/charts/plot_export.h"
#include "ui/feed/live_history.h"

#include <QList>
#include <QObject>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QColor;
class QKeyEvent;
class QMouseEvent;
class QPainter;
class QWheelEvent;

namespace gripscope {

/// A moment marked in a strip chart; x as in the stretches.
struct StripMark {
    enum class Kind { Marker, FirstCursor, SecondCursor };
    double x = 0;
    QString label; ///< a letter or a number
    Kind kind = Kind::Marker;
};

/// One channel over a stretch of time. It is handed min/max columns, so a frame costs what its width costs.
/// Where columns side by side each reach over many pixels, a pale area is filled from the lowest to the
/// highest, and the line is the mean.
/// The vertical range follows the data between round numbers and gives way slowly.
class StripChart : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    StripChart(LiveHistory::Channel channel, double leastSpan, QWidget* parent = nullptr);

    /// `factor` takes the device's unit to the one shown; `zero` (shown unit) is subtracted first: tare.
    void setScale(double factor, double zero);
    void setUnit(const QString& unit); ///< stands at the topmost tick
    /// Shows `seconds`; their end is `end_s` (<= 0) from what times are told from, which is `zero` in words.
    void setTime(double seconds, double end_s, const QString& zero);
    /// Without words at the time axis: they stand below another chart of the same time.
    void setTimeLabels(bool on);
    void setStretches(std::vector<LiveHistory::Stretch> stretches);
    /// What was asked for, to stand behind what was measured; it has no tare.
    void setCommanded(std::vector<LiveHistory::Stretch> stretches);
    /// Where samples are missing: marked, and no line goes across.
    void setGaps(std::vector<LiveHistory::Gap> gaps);
    void setMarks(std::vector<StripMark> marks);
    [[nodiscard]] const std::vector<StripMark>& marks() const { return m_marks; }
    [[nodiscard]] int columns() const; ///< pixel columns of the plot
    [[nodiscard]] double seconds() const { return m_seconds; }
    [[nodiscard]] AxisRange range() const { return m_range; }
    /// Lowest and highest measured value in view, in the unit shown; nothing while nothing is in view.
    [[nodiscard]] std::optional<AxisRange> seen() const { return m_seen; }
    [[nodiscard]] const std::vector<LiveHistory::Stretch>& stretches() const { return m_stretches; }
    [[nodiscard]] const std::vector<LiveHistory::Stretch>& commanded() const { return m_commanded; }
    [[nodiscard]] QRectF plot() const;
    /// Which share of the time shown lies left of a pixel column, 0 to 1 within the plot; and back.
    [[nodiscard]] double shareAt(double pixel) const;
    [[nodiscard]] double pixelAt(double x) const;
    /// The colour of what was commanded: 3 to 1 on the surface, behind the channel's own.
    [[nodiscard]] static QColor commandedColor();
    /// That of the area between the extremes of a curve of this colour, where the line is their mean.
    [[nodiscard]] static QColor envelopeColor(const QColor& curve);

    [[nodiscard]] QString plotName() const override;
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    /// With its name and a time axis of its own.
    void paintPicture(QPainter& painter) override;
    /// What is in view: the extremes of each column, in the unit shown.
    [[nodiscard]] PlotTable numbers() const override;

    [[nodiscard]] QSize sizeHint() const override { return {640, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 96}; }

signals:
    void painted(); ///< what was handed over last is on the screen

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void followRange();
    void paintFrame();
    void paintAxes(QPainter& painter) const;
    void paintTimeAxis(QPainter& painter, const QColor& grid) const;
    void paintValueAxis(QPainter& painter, const QColor& grid) const;
    void paintCurves(QPainter& painter) const;
    void paintGaps(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintSign(QPainter& painter, const QString& label, double at, bool cursor) const;
    void repaintFrame();

    LiveHistory::Channel m_channel;
    double m_leastSpan;
    double m_factor = 1, m_zero = 0, m_seconds = 10, m_end_s = 0;
    QString m_zeroWord;
    bool m_timeLabels = true;
    std::vector<LiveHistory::Stretch> m_stretches, m_commanded;
    std::vector<LiveHistory::Gap> m_gaps;
    std::vector<StripMark> m_marks;
    AxisRange m_range{0, 1};
    std::optional<AxisRange> m_seen;
    QString m_unit;
    QPixmap m_frame; ///< grid and labels, drawn anew only when they change
    bool m_frameValid = false;
    QSize m_pictureSize;      ///< valid: in place of that on the screen
    bool m_inPicture = false; ///< a picture is being painted
    int m_calm = 0;           ///< frames during which a smaller range would have done
};

/// What mouse, finger and keys ask of a strip chart that is held: zoom by the wheel, a drag moves what is in
/// view or the cursor below it, a double click shows all again; arrows move the view, with Shift the first
/// cursor, with Ctrl the second.
class StripGestures : public QObject {
    Q_OBJECT
public:
    explicit StripGestures(StripChart& chart);
    void setEnabled(bool on);

signals:
    void zoomAsked(double factor, double share); ///< share: of the width, from the left
    void panAsked(double share);                 ///< above 0: to later times
    void resetAsked();
    void cursorDragged(int cursor, double share); ///< 0 or 1, to that share of the width
    void cursorStepped(int cursor, int columns);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool wheel(const QWheelEvent& event);
    bool key(const QKeyEvent& event);
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void showWhatADragDoes(double pixel);
    [[nodiscard]] std::optional<int> cursorNear(double pixel) const;

    StripChart* m_chart;
    bool m_enabled = false;
    bool m_pressed = false;
    std::optional<int> m_cursor; ///< that is being dragged; else the view is
    double m_last = 0;           ///< pixel
};

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
