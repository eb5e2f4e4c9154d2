// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/squeeze_job.h"

#include <QObject>

namespace gripscope {

class LiveMarkerModel;
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

} // namespace gripscope
