// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording_markers.h"
#include "ui/models/live_marker_model.h"

#include <QObject>

class QWidget;

namespace gripscope {

class LiveHistory;
class Workbench;

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
