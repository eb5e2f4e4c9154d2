// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/overlay_plots.h"
#include "ui/charts/trend_plot.h"
#include "ui/context/workbench.h"
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/history/history_page_private.h"
#include "ui/pages/history/history_parts.h"
#include "ui/pages/types/reidentify_dialog.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/windows/file_dialog.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QHash>
#include <QMenu>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

enum Shown { ListShown, ChartsShown, EmptyShown };

} // namespace

HistoryPage::HistoryPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    d->model = new HistoryModel(this);
    d->filters = new HistoryFilterBar;
    d->work = new HistoryWork(bench);
    d->counts = new ElidedLabel;
    setRole(d->counts, "second");
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 2 * metrics::step, metrics::step);
    column->addWidget(d->filters);
    column->addWidget(buildActions());
    column->addWidget(d->counts);
    column->addWidget(d->work);
    column->addWidget(buildContent(), 1);
    buildExportMenu();

    connect(d->filters, &HistoryFilterBar::changed, this, &HistoryPage::reload);
    connect(d->model, &HistoryModel::sortAsked, this, [this](HistoryColumn sorted, Qt::SortOrder direction) {
        d->order = sorted;
        d->descending = direction == Qt::DescendingOrder;
        if (!d->stale)
            reload();
    });
    connect(d->model, &HistoryModel::pageAsked, this, [this](int page) {
        d->waiting.push_back(page);
        fetchPage();
    });
    connect(d->work, &HistoryWork::busyChanged, this, &HistoryPage::refreshActions);
    const auto outdated = [this] {
        d->stale = true;
        if (isVisible())
            reload();
    };
    connect(&bench, &Workbench::libraryChanged, this, outdated);
    connect(&bench, &Workbench::ratesChanged, this, outdated);    // gates are drawn in the charts
    (new FitExporter(bench, this))->addFigure(d->charts->view()); // its context menu
    refreshActions();
}

HistoryPage::~HistoryPage() = default;

QString HistoryPage::id() const
{
    return u"history"_s;
}
QString HistoryPage::title() const
{
    return tr("History");
}
QString HistoryPage::iconName() const
{
    return u"view-history"_s;
}
HistoryModel* HistoryPage::model() const
{
    return d->model;
}

QWidget* HistoryPage::buildActions()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    d->list = makeButton(tr("List"), u"view-list-details"_s);
    d->trend = makeButton(tr("Charts"), u"office-chart-line"_s);
    d->trend->setObjectName("historyCharts");
    auto* group = new QButtonGroup(this);
    for (QPushButton* button : {d->list, d->trend}) {
        button->setCheckable(true);
        group->addButton(button);
        line->addWidget(button);
    }
    d->list->setChecked(true);
    line->addStretch();
    d->open = makeButton(tr("Open in Fit"), u"labplot-xy-fit-curve"_s);
    d->open->setObjectName("historyOpen");
    d->again = makeButton(tr("Identify again…"), u"view-refresh"_s);
    d->again->setObjectName("historyAgain");
    d->again->setToolTip(tr("The selected squeezes with another estimator"));
    d->save = makeButton(tr("Export"), u"document-export"_s);
    d->save->setObjectName("historyExport");
    d->columns = makeButton(tr("Columns"), u"view-file-columns"_s);
    for (QPushButton* button : {d->open, d->again, d->save, d->columns})
        line->addWidget(button);
    connect(d->trend, &QPushButton::toggled, this, [this] {
        showContent();
        loadPoints();
    });
    connect(d->open, &QPushButton::clicked, this,
            [this] { d->table->severalSelected() ? overlaySelected() : openCurrent(); });
    connect(d->again, &QPushButton::clicked, this, &HistoryPage::identifyAgain);
    return bar;
}

QWidget* HistoryPage::buildContent()
{
    d->table = new HistoryTable(d->model);
    d->charts = new HistoryCharts;
    d->details = new HistoryDetails;
    d->columns->setMenu(d->table->columnsMenu());
    d->stack = new QStackedWidget;
    d->stack->setStyleSheet(u"QStackedWidget { background: transparent; }"_s);
    d->stack->addWidget(d->table);
    d->stack->addWidget(d->charts);
    d->stack->addWidget(buildEmpty());
    auto* card = makeCard();
    auto* inside = new QVBoxLayout(card);
    inside->setContentsMargins(1, 1, 1, 1);
    inside->addWidget(d->stack);
    auto* content = new QWidget;
    auto* line = new QHBoxLayout(content);
    setSpacing(line, 0, metrics::step);
    line->addWidget(card, 1);
    line->addWidget(d->details);
    connect(d->table, &HistoryTable::chosen, this, [this] {
        refreshActions();
        loadDetails();
    });
    connect(d->table, &QTableView::activated, this, &HistoryPage::openCurrent);
    connect(d->charts, &HistoryCharts::chosen, this, &HistoryPage::choose);
    return content;
}

QWidget* HistoryPage::buildEmpty()
{
    auto* empty = new QWidget;
    auto* words = new QVBoxLayout(empty);
    d->emptyTitle = makeLabel({}, "title");
    d->emptyText = makeLabel({}, "second");
    words->addStretch();
    words->addWidget(d->emptyTitle, 0, Qt::AlignHCenter);
    words->addWidget(d->emptyText, 0, Qt::AlignHCenter);
    words->addStretch();
    return empty;
}

void HistoryPage::buildExportMenu()
{
    auto* menu = new QMenu(this);
    menu->addAction(tr("All that is listed, as CSV…"), this, [this] {
        chooseFile(tr("Export as CSV"), tr("CSV (*.csv)"), u"csv"_s, &HistoryPage::exportCsv);
    });
    menu->addAction(tr("All that is listed, as JSON…"), this, [this] {
        chooseFile(tr("Export as JSON"), tr("JSON (*.json)"), u"json"_s, &HistoryPage::exportJson);
    });
    menu->addAction(tr("All that is listed, for Q-DAS…"), this, [this] {
        chooseFile(tr("Export for Q-DAS"), tr("AQDEF (*.dfq)"), u"dfq"_s, &HistoryPage::exportAqdef);
    });
    menu->addAction(tr("Report as PDF…"), this, [this] {
        chooseFile(tr("Save the report"), tr("PDF (*.pdf)"), u"pdf"_s, &HistoryPage::reportTo);
    });
    menu->addSeparator();
    d->recordings =
        menu->addAction(tr("Recordings of the selected squeezes…"), this, &HistoryPage::chooseFolder);
    d->save->setMenu(menu);
}

void HistoryPage::setActive(bool active)
{
    if (active && d->stale)
        reload();
}

HistoryQuery HistoryPage::query() const
{
    HistoryQuery query = d->filters->query();
    query.order = d->order;
    query.descending = d->descending;
    return query;
}

void HistoryPage::showContent()
{
    const bool any = d->model->rowCount() > 0;
    d->stack->setCurrentIndex(!any ? EmptyShown : d->trend->isChecked() ? ChartsShown : ListShown);
    d->details->setVisible(any);
    refreshActions();
}

void HistoryPage::refreshActions()
{
    const bool any = d->model->rowCount() > 0;
    const bool selected = d->table && d->table->selectionModel()->hasSelection();
    // Of several there is no one to open: they are laid over each other.
    const bool several = d->table && d->table->severalSelected();
    d->open->setText(several ? tr("Overlay") : tr("Open in Fit"));
    d->open->setAccessibleName(d->open->text());
    d->open->setToolTip(
        several ? tr("Force and position of the selected squeezes over each other")
                : tr("Identify the recording of the chosen squeeze again and look at it (Enter)"));
    d->open->setEnabled(d->table && d->table->currentIndex().isValid());
    d->again->setEnabled(selected);
    d->save->setEnabled(any && !d->work->busy());
    if (d->recordings)
        d->recordings->setEnabled(selected);
    d->columns->setEnabled(any && d->list->isChecked());
}

void HistoryPage::openCurrent()
{
    const QModelIndex current = d->table->currentIndex();
    if (const HistoryEntry* entry = current.isValid() ? d->model->entry(current.row()) : nullptr)
        openStoredSqueeze(workbench(), this, entry->graspId, HistoryWords::title(*entry), id());
}

void HistoryPage::overlaySelected()
{
    withSelected([this](const std::vector<QString>& keys) {
        std::vector<OverlayDialog::Chosen> chosen;
        for (std::size_t i = 0; i < std::min(keys.size(), OverlayPlots::most); ++i) {
            const HistoryEntry* entry = d->model->entry(d->model->rowOf(keys[i]));
            // One that was never in view has no words yet.
            chosen.push_back({keys[i], entry ? HistoryWords::title(*entry) : tr("Squeeze %1").arg(i + 1)});
        }
        if (!chosen.empty())
            (new OverlayDialog(workbench(), std::move(chosen), keys.size(), this))->open();
    });
}

/// Calls `then` with the keys of what is selected, at once where they are known.
void HistoryPage::withSelected(std::function<void(std::vector<QString>)> then)
{
    if (std::optional<std::vector<QString>> keys = d->table->selectedKeys()) {
        then(std::move(*keys));
        return;
    }
    constexpr auto most = qint64(HistoryList::mostCollected);
    if (d->table->selectedCount() > most) {
        workbench().messages().report(
            tr("More than %1 squeezes are selected. Select fewer, and the others after them.")
                .arg(formatCount(most)));
        return;
    }
    workbench().background().ask<std::vector<QString>>(
        this,
        [list = d->shown,
         rows = d->table->selectedRows()](Library& library) -> Expected<std::vector<QString>> {
            std::vector<QString> keys;
            for (const auto& [top, bottom] : rows) {
                ASSIGN_OR_RETURN(const auto part, library.historyKeys(*list, top, bottom - top + 1));
                keys.insert(keys.end(), part.begin(), part.end());
            }
            return keys;
        },
        [this, then = std::move(then)](Expected<std::vector<QString>> keys) {
            if (keys)
                then(std::move(*keys));
            else
                workbench().messages().report(keys.error().describe());
        });
}

void HistoryPage::identifyAgain()
{
    withSelected([this](std::vector<QString> keys) {
        if (!keys.empty())
            openIdentifyAgain(std::move(keys));
    });
}

void HistoryPage::openIdentifyAgain(std::vector<QString> keys)
{
    auto* dialog = new ReidentifyDialog(workbench(), std::move(keys), this);
    connect(dialog, &ReidentifyDialog::kept, this, [this] {
        d->detailed.clear(); // its estimates are read again
        loadDetails();
    });
    dialog->open();
}

void HistoryPage::chooseFile(const QString& title, const QString& filter, const QString& suffix,
                             void (HistoryPage::*write)(const QString&))
{
    auto* dialog = new FileDialog(this, title, QString(), filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(u"history."_s + suffix);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, write](const QString& file) { (this->*write)(file); });
    dialog->open();
}

void HistoryPage::chooseFolder()
{
    auto* dialog = new FileDialog(this, tr("Folder for the recordings"));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& folder) { exportRecordingsTo(folder); });
    dialog->open();
}

void HistoryPage::exportTo(const QString& file, HistoryFormat format)
{
    d->work->run(historyExport(query(), format, file), tr("Writing %1").arg(QFileInfo(file).fileName()),
                 tr("Squeezes written to %1").arg(file));
}

void HistoryPage::exportRecordingsTo(const QString& folder)
{
    withSelected([this, folder](std::vector<QString> keys) {
        d->work->run(recordingExport(std::move(keys), folder), tr("Writing recordings"),
                     tr("Recordings written to %1").arg(folder));
    });
}

void HistoryPage::reportTo(const QString& file)
{
    d->work->writeReport(query(), file);
}

void HistoryPage::prepareTour()
{
    d->examples = new ExampleInspections(workbench(), this);
    connect(d->examples, &ExampleInspections::finished, this, [this] {
        d->choosesFirst = true;
        reload();
    });
    d->examples->start();
}

bool HistoryPage::tourReady() const
{
    return !d->loading && d->examples && !d->examples->busy() && d->model->rowCount() > 0;
}

} // namespace gripscope
