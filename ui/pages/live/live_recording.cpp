// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live/live_recording.h"

#include "core/base/words.h"
#include "core/session/squeeze/squeeze_recorder.h"
#include "core/signal/recording/recording.h"
#include "core/signal/recording/recording_csv.h"
#include "ui/context/workbench.h"
#include "ui/feed/live_history.h"
#include "ui/models/live_marker_model.h"
#include "ui/windows/file_dialog.h"

#include <QDateTime>
#include <QDir>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

LiveTrial::LiveTrial(Workbench& workbench, const LiveMarkerModel& markers, QObject* parent)
    : QObject(parent), m_workbench(&workbench), m_markers(&markers), m_job(workbench.connection())
{
}

void LiveTrial::start()
{
    if (m_workbench->busyWithSqueeze())
        return;
    m_job.setOperator(m_workbench->operatorName());
    const ConnectSession& connection = m_workbench->connection();
    const auto seed = static_cast<std::uint64_t>(m_count + 1);
    const Expected<void> started =
        connection.identity().commandable ? m_job.start(m_recipe, seed) : m_job.listen(m_recipe.seconds);
    if (!started) {
        m_workbench->messages().report(started.error().describe());
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
        m_workbench->messages().report(m_job.error()->describe());
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
    m_workbench->background().compute<Identification>(
        this, [recording] { return identify(recording); },
        [this, recording, name](const Identification& found) {
            FitSubject subject{name, recording, found};
            if (m_openFit)
                m_workbench->navigator().showInFit(std::move(subject));
            else
                m_workbench->navigator().setFitSubject(std::move(subject));
        });
}

Recording recordingOf(const LiveHistory& history, double from_s, double until_s, const Recording& described,
                      const std::vector<LiveMarker>& markers)
{
    std::vector<Sample> samples = history.samples(from_s, until_s);
    for (std::size_t i = samples.size(); i > 1; --i)
        if (samples[i - 1].sequence <= samples[i - 2].sequence) {
            samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(i - 1));
            break;
        }
    Recording recording = described;
    if (samples.empty())
        return recording;
    // As many as would fit, so that none is left out where some were lost.
    const double longest = (samples.back().time_s - samples.front().time_s) / history.sampleTime_s();
    SqueezeRecorder recorder;
    recorder.begin(SqueezeRecorder::Mode::Everything, static_cast<std::size_t>(longest) + 3,
                   history.sampleTime_s());
    recorder.take(samples);
    recorder.moveTo(recording);
    std::vector<RecordingMarker> marked;
    for (const LiveMarker& marker : markers)
        marked.push_back({marker.time_s, marker.words});
    noteMarkers(recording, std::move(marked));
    return recording;
}

LiveSave::LiveSave(Workbench& workbench, QWidget* page) : QObject(page), m_workbench(&workbench), m_page(page)
{
}

void LiveSave::ask(const Recording& recording, double shown_s)
{
    if (recording.size() == 0) {
        m_workbench->messages().report(
            tr("Nothing in view is kept sample by sample any more: that is done for the last "
               "minute. Show a later time, then save again."));
        return;
    }
    auto* dialog = new FileDialog(m_page, tr("Save what is in view"), QString(), tr("Recording (*.csv)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"csv"_s);
    dialog->selectFile(u"live-%1.csv"_s.arg(QDateTime::currentDateTime().toString(u"yyyyMMdd-HHmmss"_s)));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, recording, shown_s](const QString& file) { write(recording, shown_s, file); });
    dialog->open();
}

void LiveSave::write(const Recording& recording, double shown_s, const QString& file)
{
    emit writing(true);
    const double saved_s = recording.time_s.back() - recording.time_s.front() + recording.sampleTime_s;
    m_workbench->background().compute<Expected<void>>(
        this, [recording, file] { return writeRecordingCsv(recording, file); },
        [this, file, saved_s, shown_s](const Expected<void>& done) {
            emit writing(false);
            const QString name = QDir::toNativeSeparators(file);
            if (!done)
                m_workbench->messages().report(done.error().describe());
            else if (saved_s < 0.99 * shown_s)
                m_workbench->messages().report(
                    tr("Saved as %1: the last %2 s of what is in view. What was before is no "
                       "longer kept sample by sample.")
                        .arg(name, Words::number(saved_s, 'f', 2)));
            else
                m_workbench->messages().tell(
                    tr("Saved as %1: %2 s.").arg(name, Words::number(saved_s, 'f', 2)));
        });
}

} // namespace gripscope
