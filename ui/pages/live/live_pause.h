// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"
#include "ui/feed/live_history.h"
#include "ui/feed/live_view.h"
#include "ui/models/live_marker_model.h"

#include <QFrame>

#include <array>
#include <optional>
#include <vector>

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTableView;
class QToolButton;

namespace gripscope {

class LiveChannelCard;
class StripGestures;
class Workbench;

/// What can be done with charts that are held: the buttons of the view, two cursors with what they read, the
/// markers. It shows and asks; what is shown comes from LivePause.
class LiveMeasurePanel : public QFrame {
    Q_OBJECT
public:
    explicit LiveMeasurePanel(LiveMarkerModel& markers, QWidget* parent = nullptr);

    struct CursorTexts {
        double time_s = 0; ///< from the moment of the pause, <= 0
        QString force, position;
    };
    struct Readout {
        std::array<CursorTexts, 2> cursors;
        QString time, force, position; ///< second less first
        QString slope;
    };
    void show(const Readout& readout);
    using QWidget::show;
    /// Times go from `oldest_s` to 0; a step of the fields is `step_s`.
    void setTimes(double oldest_s, double step_s);
    void setSaving(bool on); ///< a file is being written

signals:
    void zoomAsked(double factor);
    void panAsked(double share);
    void resetAsked();
    void cursorsAsked(); ///< into what is in view
    void cursorSet(int cursor, double time_s);
    void saveAsked();
    void markerChosen(int row);

private:
    QWidget* buildReadout();
    QWidget* buildSide();
    void addCursor(QGridLayout* grid, int cursor);
    void removeMarkers();

    LiveMarkerModel* m_markers;
    std::array<QDoubleSpinBox*, 2> m_times{};
    std::array<QLabel*, 2> m_forces{}, m_positions{};
    QLabel* m_timeBetween = nullptr;
    QLabel* m_forceBetween = nullptr;
    QLabel* m_positionBetween = nullptr;
    QLabel* m_slope = nullptr;
    QTableView* m_table = nullptr;
    QToolButton* m_remove = nullptr;
    QPushButton* m_save = nullptr;
};

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
    void placeCursors();
    void keepCursorsInView();
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
