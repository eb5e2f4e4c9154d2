// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/identification/recursive/recursive_estimator.h"
#include "core/session/connection/latency_histogram.h"
#include "ui/charts/strip_chart.h"
#include "ui/format/cursor_reading.h"

#include <QFrame>

#include <array>
#include <map>
#include <optional>

class QGridLayout;
class QLabel;

namespace gripscope {

class ElidedLabel;
class LiveView;
class Workbench;

/// One channel of the Live page: its strip chart, and beside it the value now, in the unit shown.
class LiveChannelCard : public QFrame {
    Q_OBJECT
public:
    LiveChannelCard(LiveHistory::Channel channel, const QString& name, QWidget* parent = nullptr);

    /// The device's unit decides what takes its numbers to those shown; unknown units stay as they are.
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
    /// N or mm, or what the person reads in their place.
    [[nodiscard]] ShownUnit unitShown() const;
    [[nodiscard]] QString number(double shown) const;
};

/// m, b and k of the squeeze under way in one line, with their 95 % intervals.
class LiveEstimateCard : public QFrame {
    Q_OBJECT
public:
    explicit LiveEstimateCard(QWidget* parent = nullptr);
    void show(const std::optional<RecursiveState>& state, bool following, const QString& forceUnit,
              const QString& positionUnit);
    using QWidget::show;

private:
    QLabel* m_what;
    std::array<QLabel*, 3> m_values;
    QLabel* m_samples;
};

/// The link at a glance: is it there, how fast, what was lost and when, how old is what the screen shows; and
/// whether the gripper may move, how far, and whether it does.
class LiveLinkPanel : public QFrame {
    Q_OBJECT
public:
    explicit LiveLinkPanel(Workbench& workbench, QWidget* parent = nullptr);

    /// The newest sample is on the screen now: its age counts as the latency.
    void notePainted();
    void refresh();
    /// What stands under a caption: link, reports, samples, lost, latency, armed, force, travel, excitation,
    /// stream.
    [[nodiscard]] QString text(const QString& id) const;

private:
    void add(QGridLayout* grid, const QString& id, const QString& caption, int row, int column);
    void set(const QString& id, const QString& text);
    void refreshStream();
    void refreshGripper();
    Workbench* m_workbench;
    std::map<QString, ElidedLabel*> m_values;
    std::map<QString, QString> m_texts;
    LatencyHistogram m_painted;
    std::optional<LatencyHistogram::TimePoint> m_paintedArrival; ///< of the newest sample on the screen
};

} // namespace gripscope
