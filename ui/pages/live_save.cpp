// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live_save.h"

#include "core/session/squeeze_recorder.h"
#include "core/signal/recording_csv.h"
#include "core/words.h"
#include "ui/live_history.h"
#include "ui/workbench.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>

namespace gripscope {

using namespace Qt::StringLiterals;

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
        m_workbench->report(tr("Nothing in view is kept sample by sample any more: that is done for the last "
                               "minute. Show a later time, then save again."));
        return;
    }
    auto* dialog = new QFileDialog(m_page, tr("Save what is in view"), QString(), tr("Recording (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
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
    m_workbench->compute<Expected<void>>(
        this, [recording, file] { return writeRecordingCsv(recording, file); },
        [this, file, saved_s, shown_s](const Expected<void>& done) {
            emit writing(false);
            const QString name = QDir::toNativeSeparators(file);
            if (!done)
                m_workbench->report(done.error().describe());
            else if (saved_s < 0.99 * shown_s)
                m_workbench->report(tr("Saved as %1: the last %2 s of what is in view. What was before is no "
                                       "longer kept sample by sample.")
                                        .arg(name, Words::number(saved_s, 'f', 2)));
            else
                m_workbench->report(tr("Saved as %1: %2 s.").arg(name, Words::number(saved_s, 'f', 2)));
        });
}

} // namespace gripscope
