// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live_trial.h"

#include "core/signal/recording_markers.h"
#include "ui/models/live_marker_model.h"
#include "ui/workbench.h"

#include <algorithm>

namespace gripscope {

LiveTrial::LiveTrial(Workbench& workbench, const LiveMarkerModel& markers, QObject* parent)
    : QObject(parent), m_workbench(&workbench), m_markers(&markers), m_job(workbench.connection())
{
}

void LiveTrial::start()
{
    if (m_workbench->squeezing()) {
        m_workbench->report(tr("Another squeeze is under way. Wait for its end, then try again."));
        return;
    }
    m_job.setOperator(m_workbench->operatorName());
    const ConnectSession& connection = m_workbench->connection();
    const auto seed = static_cast<std::uint64_t>(m_count + 1);
    const Expected<void> started =
        connection.identity().commandable ? m_job.start(m_recipe, seed) : m_job.listen(m_recipe.seconds);
    if (!started) {
        m_workbench->report(started.error().describe());
        return;
    }
    ++m_count;
    m_link = connection.reconnections();
    m_running = true;
    m_workbench->setTrialRunning(true);
    emit changed();
}

void LiveTrial::follow()
{
    if (!m_running)
        return;
    m_job.poll();
    if (m_job.state() != SqueezeJob::State::Done && m_job.state() != SqueezeJob::State::Failed)
        return;
    m_running = false;
    m_workbench->setTrialRunning(false);
    emit changed();
    if (m_job.state() == SqueezeJob::State::Failed)
        m_workbench->report(m_job.error()->describe());
    else
        identifyResult();
}

Recording LiveTrial::markedRecording() const
{
    Recording recording = m_job.recording();
    std::vector<RecordingMarker> marked;
    for (const LiveMarker& marker : m_markers->markers()) {
        if (marker.link != m_link || !marker.sequence)
            continue;
        // By the sample's number: after a return of the gripper the charts have a time of their own.
        const auto sample =
            std::lower_bound(recording.sequence.begin(), recording.sequence.end(), *marker.sequence);
        if (sample != recording.sequence.end() && *sample == *marker.sequence)
            marked.push_back({recording.time_s[static_cast<std::size_t>(sample - recording.sequence.begin())],
                              marker.words});
    }
    noteMarkers(recording, std::move(marked));
    return recording;
}

void LiveTrial::identifyResult()
{
    const Recording recording = markedRecording();
    const QString name = tr("Trial squeeze %1").arg(m_count);
    m_workbench->compute<Identification>(
        this, [recording] { return identify(recording); },
        [this, recording, name](const Identification& found) {
            FitSubject subject{name, recording, found};
            if (m_openFit)
                m_workbench->showInFit(std::move(subject));
            else
                m_workbench->setFitSubject(std::move(subject));
        });
}

} // namespace gripscope
