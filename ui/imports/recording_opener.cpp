// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/imports/recording_opener.h"

#include "ui/context/workbench.h"
#include "ui/imports/foreign_table_dialog.h"
#include "ui/imports/import_layouts.h"
#include "ui/settings/values/settings.h"

#include <QFileInfo>
#include <QPointer>

#include <utility>

namespace gripscope {

RecordingOpener::RecordingOpener(Workbench& workbench, QWidget* page)
    : QObject(page), m_workbench(&workbench), m_page(page)
{
}

RecordingOpener::Opened RecordingOpener::read(const QString& file)
{
    Opened opened{readRecordingCsv(file), std::nullopt};
    if (opened.recording || opened.recording.error().code != ErrorCode::BadInput)
        return opened;
    const Expected<QByteArray> head = readTableHead(file);
    if (!head || head->contains("# gripscope-recording:"))
        return opened; // Gripscope's own, and damaged: there is nothing to ask
    if (const Expected<ForeignTable> table = examineTable(*head, file))
        opened.foreign = Foreign{file, *head, *table};
    return opened;
}

void RecordingOpener::open(const QString& file, std::function<void(Recording)> then,
                           std::function<void()> otherwise, Asking asking)
{
    m_workbench->background().compute<Opened>(
        this, [file] { return read(file); },
        [this, asking, then = std::move(then), otherwise = std::move(otherwise)](Opened opened) {
            if (opened.recording) {
                then(std::move(*opened.recording));
            } else if (opened.foreign) {
                const auto before = layoutIn(m_workbench->settings().importLayouts(), opened.foreign->table);
                if (before && asking == Asking::OnlyOfNew)
                    readAsBefore(*opened.foreign, *before, then, otherwise);
                else
                    ask(*opened.foreign, then, otherwise);
            } else {
                m_workbench->messages().report(opened.recording.error().describe());
                otherwise();
            }
        });
}

void RecordingOpener::readAsBefore(const Foreign& foreign, const CsvReadOptions& before,
                                   std::function<void(Recording)> then, std::function<void()> otherwise)
{
    m_workbench->background().compute<Expected<Recording>>(
        this, [file = foreign.file, before] { return readForeignTable(file, before); },
        [this, foreign, then = std::move(then),
         otherwise = std::move(otherwise)](Expected<Recording> recording) {
            if (recording)
                then(std::move(*recording));
            else
                ask(foreign, then, otherwise); // which says what is wrong
        });
}

void RecordingOpener::ask(const Foreign& foreign, std::function<void(Recording)> then,
                          std::function<void()> otherwise)
{
    const CsvReadOptions proposal = layoutIn(m_workbench->settings().importLayouts(), foreign.table)
                                        .value_or(proposedReading(foreign.table));
    auto* dialog = new ForeignTableDialog(QFileInfo(foreign.file).fileName(), foreign.head, proposal, m_page);
    connect(dialog, &QDialog::rejected, this, std::move(otherwise));
    connect(dialog, &ForeignTableDialog::wanted, this,
            [this, dialog, foreign, then = std::move(then)](const CsvReadOptions& options) {
                dialog->setReading(true);
                m_workbench->background().compute<Expected<Recording>>(
                    dialog, [file = foreign.file, options] { return readForeignTable(file, options); },
                    [this, dialog, table = foreign.table, options, then](Expected<Recording> recording) {
                        dialog->setReading(false);
                        if (!recording) {
                            dialog->showProblem(recording.error().describe());
                            return;
                        }
                        Settings& settings = m_workbench->settings();
                        settings.setImportLayouts(withLayout(settings.importLayouts(), table, options));
                        dialog->accept();
                        then(std::move(*recording));
                    });
            });
    dialog->open();
}

} // namespace gripscope
