// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/history_work.h"

#include "ui/reports/history_report.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/number_format.h"
#include "ui/workbench.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QProgressBar>

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
            m_workbench->report(done);
    });
    work->start();
}

void HistoryWork::writeReport(const HistoryQuery& query, const QString& file)
{
    if (m_busy)
        return;
    begin(tr("Writing %1").arg(QFileInfo(file).fileName()));
    m_cancel->setVisible(false); // one step, of some seconds at the most
    m_workbench->ask<HistoryReport>(
        this, [query](Library& library) { return readHistoryReport(library, query); },
        [this, file](Expected<HistoryReport> report) {
            if (!report) {
                end();
                m_workbench->report(report.error().describe());
                return;
            }
            report->models = m_workbench->inspection().models();
            report->operatorName = m_workbench->operatorName();
            report->made = QDateTime::currentDateTimeUtc();
            m_workbench->compute<Expected<void>>(
                this, [read = std::move(*report), file] { return writeHistoryReport(read, file); },
                [this, file](Expected<void> written) {
                    end();
                    m_workbench->report(written ? tr("Report written to %1").arg(file)
                                                : written.error().describe());
                });
        });
}

} // namespace gripscope
