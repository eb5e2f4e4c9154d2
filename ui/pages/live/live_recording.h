// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/squeeze/squeeze_job.h"
#include "core/signal/recording/recording.h"
#include "ui/models/live_marker_model.h"

#include <QObject>

class QWidget;

namespace gripscope {

class LiveHistory;
class Workbench;

/// A trial squeeze of the Live page: recorded with the markers dropped meanwhile, identified, handed to the
/// Fit page, not stored. A gripper that only streams is listened to instead.
class LiveTrial : public QObject {
    Q_OBJECT
public:
    LiveTrial(Workbench& workbench, const LiveMarkerModel& markers, QObject* parent);

    void start();
    void cancel() { m_job.cancel(); }
    void follow(); ///< once a tick
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] double progress() const { return m_job.progress(); }
    [[nodiscard]] const Recipe& recipe() const { return m_recipe; }
    /// Whether the result brings the Fit page into view.
    void setOpenFit(bool open) { m_openFit = open; }

signals:
    void changed(); ///< began or ended

private:
    void identifyResult();
    [[nodiscard]] Recording markedRecording() const;

    Workbench* m_workbench;
    const LiveMarkerModel* m_markers;
    SqueezeJob m_job;
    Recipe m_recipe;
    bool m_running = false, m_openFit = true;
    int m_count = 0;
    int m_link = 0; ///< how often the gripper had come back when it began
};

/// What of a stretch of the live history is still kept sample by sample, as a recording with the markers in
/// it; `described` says what measured it. Where the gripper went away and came back in between, its samples
/// count anew: what came after that.
[[nodiscard]] Recording recordingOf(const LiveHistory& history, double from_s, double until_s,
                                    const Recording& described, const std::vector<LiveMarker>& markers);

/// Asks for a file and writes a recording there, off the screen's thread.
class LiveSave : public QObject {
    Q_OBJECT
public:
    LiveSave(Workbench& workbench, QWidget* page);
    /// `shown_s`: how long a stretch was to be saved, of which `recording` may be the last part only.
    void ask(const Recording& recording, double shown_s);
    void write(const Recording& recording, double shown_s, const QString& file);

signals:
    void writing(bool on);

private:
    Workbench* m_workbench;
    QWidget* m_page;
};

} // namespace gripscope
