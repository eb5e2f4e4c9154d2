// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/strip_chart.h"
#include "ui/models/cursor_reading.h"

#include <QFrame>

class QLabel;

namespace gripscope {

class LiveView;

/// One channel of the Live page: its strip chart, and beside it the value now, in the unit shown.
class LiveChannelCard : public QFrame {
    Q_OBJECT
public:
    LiveChannelCard(LiveHistory::Channel channel, const QString& name, QWidget* parent = nullptr);

    /// The device's unit decides what takes its numbers to N or mm; unknown units are shown as they are.
    void setDeviceUnit(const QString& unit);
    void setZero(double shown) { m_zero = shown; }
    [[nodiscard]] double zero() const { return m_zero; }
    [[nodiscard]] StripChart& chart() { return *m_chart; }

    void refreshChart(const LiveHistory& history, const LiveView& view);
    /// "12.31 N", with the tare; "12.10 to 12.90 N" for a range; a dash for nothing.
    [[nodiscard]] QString readingText(const std::optional<ReadValue>& reading) const;
    /// "3.10 ± 0.06 N"; tare plays no part in it.
    [[nodiscard]] QString changeText(const std::optional<ReadValue>& change) const;
    /// The mean of the last tenth of a second: what a person can read, with the channel's noise averaged.
    void refreshValue(const LiveHistory& history, double until_s);
    /// That mean in the unit shown, before tare; nothing without samples.
    [[nodiscard]] std::optional<double> meanNow(const LiveHistory& history, double until_s) const;
    void showNoValue();
    /// Whether this program can ask the gripper for a force: then the legend has a line for it.
    void setCommandable(bool on);

private:
    void buildSide(const QString& name);
    void showCommanded(const LiveHistory& history, double until_s);
    LiveHistory::Channel m_channel;
    StripChart* m_chart;
    QLabel* m_value;
    QLabel* m_unitLabel;
    QLabel* m_tared;
    QLabel* m_seen;
    QLabel* m_commanded = nullptr; ///< of the force only
    QWidget* m_legend = nullptr;
    double m_factor = 1, m_zero = 0;
    int m_decimals = 2;
    [[nodiscard]] QString number(double shown) const;
};

} // namespace gripscope
