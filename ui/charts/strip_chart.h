// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/live_history.h"
#include "ui/widgets/axis_ticks.h"

#include <QPixmap>
#include <QWidget>

#include <optional>

namespace gripscope {

/// One channel over the last seconds, newest on the right. It is handed min/max columns, so a frame costs
/// what its width costs. The vertical range follows the data between round numbers and gives way slowly.
class StripChart : public QWidget {
    Q_OBJECT
public:
    StripChart(LiveHistory::Channel channel, double leastSpan, QWidget* parent = nullptr);

    /// `factor` takes the device's unit to the one shown; `zero` (shown unit) is subtracted first: tare.
    void setScale(double factor, double zero);
    void setUnit(const QString& unit); ///< stands at the topmost tick
    void setSeconds(double seconds);
    void setStretches(std::vector<LiveHistory::Stretch> stretches);
    /// Where samples are missing: marked, and no line goes across.
    void setGaps(std::vector<LiveHistory::Gap> gaps);
    [[nodiscard]] int columns() const; ///< pixel columns of the plot
    [[nodiscard]] double seconds() const { return m_seconds; }
    [[nodiscard]] AxisRange range() const { return m_range; }
    /// Lowest and highest value in view, in the unit shown; nothing while nothing is in view.
    [[nodiscard]] std::optional<AxisRange> seen() const { return m_seen; }
    [[nodiscard]] const std::vector<LiveHistory::Stretch>& stretches() const { return m_stretches; }

    [[nodiscard]] QSize sizeHint() const override { return {640, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 96}; }

signals:
    void painted(); ///< what was handed over last is on the screen

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QRectF plot() const;
    void followRange();
    void paintFrame();
    void paintCurve(QPainter& painter) const;
    void paintGaps(QPainter& painter) const;

    LiveHistory::Channel m_channel;
    double m_leastSpan;
    double m_factor = 1, m_zero = 0, m_seconds = 10;
    std::vector<LiveHistory::Stretch> m_stretches;
    std::vector<LiveHistory::Gap> m_gaps;
    AxisRange m_range{0, 1};
    std::optional<AxisRange> m_seen;
    QString m_unit;
    QPixmap m_frame; ///< grid and labels, drawn anew only when they change
    bool m_frameValid = false;
    int m_calm = 0; ///< frames during which a smaller range would have done
};

} // namespace gripscope
