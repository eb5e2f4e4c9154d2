// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"
#include "ui/live_history.h"
#include "ui/live_view.h"
#include "ui/models/live_marker_model.h"

#include <QObject>

#include <array>
#include <optional>
#include <vector>

class QWidget;

namespace gripscope {

class LiveChannelCard;
class LiveMeasurePanel;
class StripGestures;
class Workbench;

/// The two charts of the Live page, and what becomes of them while they are held: a copy of the history as it
/// was, so that nothing goes while somebody looks at it, a part of it in view, two cursors.
class LivePause : public QObject {
    Q_OBJECT
public:
    LivePause(Workbench& workbench, LiveChannelCard& force, LiveChannelCard& position,
              LiveMarkerModel& markers, QWidget* page);

    void setHeld(bool on);
    [[nodiscard]] bool held() const { return m_held.has_value(); }
    void setSpan(double seconds);
    void refreshCharts(); ///< from the live history, or again from the one that is held
    [[nodiscard]] LiveMeasurePanel& panel() { return *m_panel; }
    [[nodiscard]] const LiveView& view() const { return m_view; }
    [[nodiscard]] const LiveHistory& history() const;

    /// A marker at the cursor moved last, or at the newest sample.
    [[nodiscard]] LiveMarker marker() const;

    /// What is in view as a recording, as far as it is kept sample by sample. Only while held.
    [[nodiscard]] Recording recordingInView() const;

    // What buttons, keys and gestures ask for while held.
    void zoom(double factor, double share = 0.5);
    void pan(double share);
    void reset();
    void setCursor(int cursor, double time_s); ///< device time
    void stepCursor(int cursor, int columns);
    void bringCursors(); ///< into what is in view

signals:
    void saveAsked();

private:
    void connectCharts();
    void connectPanel();
    void refreshMarks();
    void refreshReadout();
    void refreshView();
    [[nodiscard]] std::vector<LiveChannelCard*> cards() const { return {m_force, m_position}; }

    Workbench* m_workbench;
    LiveChannelCard* m_force;
    LiveChannelCard* m_position;
    LiveMarkerModel* m_markers;
    LiveMeasurePanel* m_panel;
    LiveView m_view;
    std::optional<LiveHistory> m_held;
    Recording m_described; ///< what measured it
    QDateTime m_heldAt;
    int m_heldLink = 0; ///< how often the gripper had come back by then
    std::array<double, 2> m_cursors_s{};
    int m_movedLast = 0;
    std::vector<StripGestures*> m_gestures;
};

} // namespace gripscope
