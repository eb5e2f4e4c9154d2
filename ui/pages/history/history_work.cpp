// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/work_watch.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/signal/recording/recording_csv.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/history/history_parts.h"
#include "ui/reports/reports.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPointer>
#include <QProgressBar>
#include <QRegularExpression>
#include <QSaveFile>

#include <memory>

using namespace Qt::StringLiterals;

namespace gripscope {

HistoryWork::HistoryWork(Workbench& workbench, QWidget* parent)
    : QFrame(parent), m_workbench(&workbench), m_text(makeLabel({})), m_progress(new QProgressBar),
      m_cancel(makeButton(tr("Cancel")))
{
    setRole(this, "card");
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(2 * metrics::step, metrics::insideControl, metrics::insideControl,
                             metrics::insideControl);
    line->setSpacing(2 * metrics::step);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_cancel->setObjectName("historyCancel");
    line->addWidget(m_text);
    line->addWidget(m_progress, 1);
    line->addWidget(m_cancel);
    hide();
}

void HistoryWork::begin(const QString& doing)
{
    m_busy = true;
    m_text->setText(doing);
    m_progress->setRange(0, 0);
    show();
    emit busyChanged();
}

void HistoryWork::end()
{
    m_busy = false;
    hide();
    emit busyChanged();
}

void HistoryWork::run(SteppedWork::Step step, const QString& doing, const QString& done)
{
    if (m_busy)
        return;
    begin(doing);
    auto* work = new SteppedWork(*m_workbench, std::move(step), this);
    m_cancel->setVisible(true);
    connect(m_cancel, &QPushButton::clicked, work, &SteppedWork::cancel);
    connect(work, &SteppedWork::progressed, this, [this, doing](qsizetype count, qsizetype total) {
        m_progress->setRange(0, int(std::max<qsizetype>(1, total)));
        m_progress->setValue(int(count));
        m_text->setText(tr("%1: %2 of %3").arg(doing, formatCount(count), formatCount(total)));
    });
    connect(work, &SteppedWork::ended, this, [this, done](bool complete) {
        end();
        if (complete)
            m_workbench->messages().tell(done);
    });
    work->start();
}

void HistoryWork::writeReport(const HistoryQuery& query, const QString& file)
{
    if (m_busy)
        return;
    begin(tr("Writing %1").arg(QFileInfo(file).fileName()));
    m_cancel->setVisible(true);
    auto watch = std::make_shared<WorkWatch>();
    auto* cancelling = new QObject(this); // as long as there is something to cancel
    connect(m_cancel, &QPushButton::clicked, cancelling, [this, watch, cancelling] {
        watch->stop();
        cancelling->deleteLater();
        end();
    });
    const auto finish = [this, cancelling = QPointer<QObject>(cancelling)] {
        delete cancelling;
        end();
    };
    m_workbench->background().ask<HistoryReport>(
        this,
        [query, file, watch](Library& library) -> Expected<HistoryReport> {
            if (watch->stopped())
                return failure(ErrorCode::Cancelled, {});
            ASSIGN_OR_RETURN(HistoryReport report, readHistoryReport(library, query));
            if (watch->stopped()) // nothing leaves the library
                return failure(ErrorCode::Cancelled, {});
            RETURN_IF_ERROR(numberHistoryReport(library, report, file));
            return report;
        },
        [this, file, watch, finish](Expected<HistoryReport> report) {
            if (watch->stopped())
                return;
            if (!report) {
                finish();
                m_workbench->messages().report(report.error().describe());
                return;
            }
            report->models = m_workbench->inspection().models();
            report->rates = m_workbench->rates().rates;
            report->operatorName = m_workbench->operatorName();
            report->letterhead = letterheadSource(m_workbench->settings());
            report->made = QDateTime::currentDateTimeUtc();
            m_workbench->background().compute<Expected<void>>(
                this,
                [read = std::move(*report), file, watch] { return writeHistoryReport(read, file, watch); },
                [this, file, watch, finish](Expected<void> written) {
                    if (watch->stopped())
                        return;
                    finish();
                    if (written)
                        m_workbench->messages().tell(tr("Report written to %1").arg(file));
                    else
                        m_workbench->messages().report(written.error().describe());
                });
        });
}

namespace {

/// Last first: they are taken from the end.
std::vector<Recording> simulateExamples()
{
    std::vector<Recording> recordings;
    const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
    std::uint64_t seed = 1;
    for (const std::size_t row : {31, 5, 12, 25, 2, 38, 17})
        recordings.push_back(simulatedSqueeze(squeezes[row].parameters, seed++));
    recordings.push_back(simulatedSqueeze({0.06, 70, 15000}, seed)); // none of the types
    return recordings;
}

} // namespace

ExampleInspections::ExampleInspections(Workbench& workbench, QObject* parent)
    : QObject(parent), m_workbench(&workbench)
{
    connect(m_workbench, &Workbench::ticked, this, [this] { judgeNext(); });
}

void ExampleInspections::start()
{
    m_busy = true;
    m_workbench->background().ask<InspectionCounts>(
        this, [](Library& library) { return library.inspectionCounts(); },
        [this](Expected<InspectionCounts> counts) {
            if (!counts || counts->total > 0) {
                finish();
                return;
            }
            m_workbench->background().compute<std::vector<Recording>>(
                this, simulateExamples, [this](std::vector<Recording> recordings) {
                    m_waiting = std::move(recordings);
                    m_simulated = true;
                });
        });
}

void ExampleInspections::judgeNext()
{
    InspectSession& inspection = m_workbench->inspection();
    if (!m_busy || !m_simulated || inspection.state() != InspectSession::State::Ready)
        return;
    if (inspection.storing())
        return;
    if (m_waiting.empty() || !inspection.judgeRecording(m_waiting.back(), u"simulated"_s)) {
        finish();
        return;
    }
    m_waiting.pop_back();
}

void ExampleInspections::finish()
{
    m_busy = false;
    m_waiting.clear();
    emit finished();
}

namespace {

/// A file that is being written; without commit() nothing of it stays.
struct WholeFile {
    WholeFile(const HistoryQuery& query, HistoryFormat as, const QString& name)
        : document(query, as), format(toString(as)), file(name)
    {
    }
    HistoryDocument document;
    QString format;
    QSaveFile file;
};

} // namespace

SteppedWork::Step historyExport(const HistoryQuery& query, HistoryFormat format, const QString& file)
{
    auto writing = std::make_shared<WholeFile>(query, format, file);
    return [writing](Library& library) -> Expected<SteppedWork::Progress> {
        QSaveFile& out = writing->file;
        const auto failed = [&out] {
            return failure(ErrorCode::FileUnwritable, {out.fileName(), out.errorString()});
        };
        if (!out.isOpen() && !out.open(QIODevice::WriteOnly))
            return failed();
        ASSIGN_OR_RETURN(const QByteArray piece, writing->document.next(library));
        if (out.write(piece) != piece.size())
            return failed();
        if (writing->document.ended()) { // what cannot be told does not leave the library
            RETURN_IF_ERROR(library.tellExport(out.fileName(), writing->format,
                                               static_cast<qint64>(writing->document.written())));
            if (!out.commit())
                return failed();
        }
        return SteppedWork::Progress{writing->document.written(), writing->document.total(),
                                     !writing->document.ended()};
    };
}

QString recordingFileName(const HistoryEntry& entry)
{
    if (entry.number > 0)
        return u"inspection_%1.csv"_s.arg(entry.number, 6, 10, QChar(u'0'));
    static const QRegularExpression awkward(u"[^\\w-]+"_s, QRegularExpression::UseUnicodePropertiesOption);
    QString type = entry.type;
    type.replace(awkward, u"_"_s);
    return u"enrolment_%1_%2.csv"_s.arg(type, entry.graspId.right(8));
}

namespace {

/// The name, or where that is taken "inspection_000412_2.csv": what lies there is not ours to replace.
QString freeFile(const QString& folder, const QString& name)
{
    const QDir place(folder);
    const QFileInfo wanted(name);
    QString file = place.filePath(name);
    for (int number = 2; QFileInfo::exists(file); ++number)
        file = place.filePath(
            u"%1_%2.%3"_s.arg(wanted.completeBaseName(), QString::number(number), wanted.suffix()));
    return file;
}

} // namespace

SteppedWork::Step recordingExport(std::vector<QString> graspIds, const QString& folder)
{
    struct Writing {
        std::vector<QString> ids;
        std::size_t next = 0;
    };
    auto writing = std::make_shared<Writing>(Writing{std::move(graspIds), 0});
    return [writing, folder](Library& library) -> Expected<SteppedWork::Progress> {
        const SteppedWork::Progress nothing{0, 0, false};
        if (writing->next >= writing->ids.size())
            return nothing;
        if (writing->next == 0) // what cannot be told does not leave the library
            RETURN_IF_ERROR(
                library.tellExport(folder, u"recordings"_s, static_cast<qint64>(writing->ids.size())));
        const QString id = writing->ids[writing->next++];
        ASSIGN_OR_RETURN(const auto entries, library.historyEntries({id}));
        const auto recording = library.recording(id);
        if (!recording && recording.error().code != ErrorCode::NotFound)
            return tl::unexpected<Error>(recording.error());
        if (recording && !entries.empty())
            RETURN_IF_ERROR(
                writeRecordingCsv(*recording, freeFile(folder, recordingFileName(entries.front()))));
        return SteppedWork::Progress{writing->next, writing->ids.size(), writing->next < writing->ids.size()};
    };
}

} // namespace gripscope
