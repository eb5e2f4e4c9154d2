// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the window: the points of the charts as a table, and a report.
#include "core/base/bounded_file.h"
#include "core/library/library.h"
#include "ui/charts/control_plot.h"
#include "ui/context/workbench.h"
#include "ui/pages/quality/process/process_capability_panel.h"
#include "ui/pages/quality/process/process_controls.h"
#include "ui/pages/quality/process/process_names.h"
#include "ui/pages/quality/process/process_signal_list.h"
#include "ui/pages/quality/process/process_view.h"
#include "ui/reports/quality_reports.h"
#include "ui/windows/file_dialog.h"

#include <functional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t mostReportedSignals = 60;

/// First into the audit trail, as every export; then `write` in the pool, and what came of it is told.
void exportProcess(Workbench& bench, QWidget* context, const QString& file, const QString& format,
                   qint64 rows, const QString& told, std::function<Expected<void>()> write)
{
    bench.background().ask<void>(
        context, [file, format, rows](Library& library) { return library.tellExport(file, format, rows); },
        [&bench, context, told, write = std::move(write)](const Expected<void>& entered) {
            if (!entered)
                return bench.messages().report(entered.error().describe());
            bench.background().compute<Expected<void>>(
                context, write, [&bench, told](const Expected<void>& done) {
                    if (done)
                        bench.messages().tell(told);
                    else
                        bench.messages().report(done.error().describe());
                });
        });
}

std::vector<ReportedSignal> reportedSignals(const ProcessPicture& picture)
{
    std::vector<ReportedSignal> reported;
    for (const SignalLine& line : signalLines(picture, ProcessNames::allQuantities, mostReportedSignals))
        reported.push_back({QString::number(line.number), line.time, line.quantity, line.what, line.since});
    return reported;
}

std::vector<ReportedCapability> reportedCapabilities(const ProcessPicture& picture)
{
    std::vector<ReportedCapability> reported;
    for (const std::size_t quantity : {2U, 0U, 1U}) {
        if (!picture.capabilities[quantity])
            continue;
        ReportedCapability one;
        one.capability = *picture.capabilities[quantity];
        for (const CapabilityLine& line : CapabilityNumbers::of(one.capability))
            one.lines.push_back({line.name, line.value, line.interval});
        one.sentences = CapabilityNumbers::sentences(one.capability);
        reported.push_back(std::move(one));
    }
    return reported;
}

} // namespace

void ProcessView::chooseFile(const QString& title, const QString& filter, const QString& suffix,
                             void (ProcessView::*write)(const QString&))
{
    auto* dialog = new FileDialog(this, title, QString(), filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(u"control_chart."_s + suffix);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, write](const QString& file) { (this->*write)(file); });
    dialog->open();
}

void ProcessView::writeCsv(const QString& file)
{
    if (!m_shown)
        return;
    exportProcess(*m_workbench, this, file, u"csv"_s, qint64(m_shown->rows.size()),
                  tr("Points written to %1").arg(file),
                  [picture = m_shown, panels = m_charts->panels(), file] {
                      return writeWhole(file, toCsv(controlNumbers(*picture, panels)));
                  });
}

void ProcessView::writeReport(const QString& file)
{
    if (!m_shown)
        return;
    const ProcessFilter& filter = m_shown->filter;
    ProcessReport report;
    report.picture = m_shown;
    report.panels = ProcessNames::panels(*m_shown, ProcessNames::allQuantities);
    report.type = m_session.query().type;
    report.chart = ProcessNames::kind(m_shown->options.kind);
    report.rules =
        takesRules(m_shown->options.kind) ? ProcessNames::rules(m_shown->options.rules) : QString();
    report.limits = ProcessNames::limits(m_session);
    QStringList narrowed{m_session.query().gripper, filter.station, filter.operatorName, filter.batch};
    narrowed.removeAll(QString());
    report.narrowed = narrowed.join(u", "_s);
    report.found = reportedSignals(*m_shown);
    report.signalCount = countSignals(*m_shown, ProcessNames::allQuantities);
    report.pointCount = countPoints(*m_shown, ProcessNames::allQuantities);
    report.capabilities = reportedCapabilities(*m_shown);
    report.letterhead = letterheadSource(m_workbench->settings());
    report.operatorName = m_workbench->operatorName();
    report.made = QDateTime::currentDateTimeUtc();
    exportProcess(*m_workbench, this, file, u"pdf"_s, qint64(m_shown->rows.size()),
                  tr("Report written to %1").arg(file),
                  [report, file] { return writeProcessReport(report, file); });
}

} // namespace gripscope
