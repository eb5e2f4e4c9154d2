// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/history/history_page.h"

#include "ui/context/workbench.h"
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/history/history_parts.h"
#include "ui/pages/types/reidentify_dialog.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/windows/file_dialog.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QStackedWidget>

#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t mostPagesWaiting = 3; ///< while the list is scrolled fast, only the last are fetched

/// What one visit to the library brings back.
struct HistoryStart {
    HistoryCounts counts;
    bool empty = false; ///< the whole library
    HistoryChoices choices;
    HistoryKeys keys;
    std::vector<HistoryEntry> first;
};

template <typename T>
bool take(Expected<T> found, T& into, std::optional<Error>& error)
{
    if (found)
        into = std::move(*found);
    else
        error = found.error();
    return found.has_value();
}

Expected<HistoryStart> fetchStart(Library& library, const HistoryQuery& query)
{
    HistoryStart start;
    std::optional<Error> error;
    const bool read =
        take(library.historyCounts(query), start.counts, error) &&
        take(library.historyChoices(), start.choices, error) &&
        take(library.historyKeys(query), start.keys, error) &&
        take(library.historyEntries(start.keys.part(0, HistoryModel::pageSize)), start.first, error);
    if (!read)
        return tl::unexpected<Error>(*error);
    start.empty = start.keys.empty() && start.choices.operators.isEmpty() && query.everything();
    return start;
}

enum Shown { ListShown, ChartsShown, EmptyShown };

} // namespace

struct HistoryPage::Private {
    HistoryModel* model = nullptr;
    HistoryTable* table = nullptr;
    HistoryCharts* charts = nullptr;
    HistoryDetails* details = nullptr;
    HistoryFilterBar* filters = nullptr;
    HistoryWork* work = nullptr;
    QStackedWidget* stack = nullptr;
    QPushButton *list = nullptr, *trend = nullptr, *open = nullptr, *again = nullptr, *save = nullptr,
                *columns = nullptr;
    QAction* recordings = nullptr;
    ElidedLabel* counts = nullptr;
    QLabel *emptyTitle = nullptr, *emptyText = nullptr;
    HistoryColumn order = HistoryColumn::Time;
    bool descending = true;
    std::vector<int> waiting; ///< pages that were asked for, the last first to be fetched
    bool fetching = false;
    int generation = 0; ///< of the list; answers to an older one do not count
    int pointsGeneration = -1;
    QString detailed; ///< whose details are shown or on their way
    bool stale = true, loading = false;
    bool choosesFirst = false; ///< of the next list
    ExampleInspections* examples = nullptr;
};

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
    connect(&bench, &Workbench::libraryChanged, this, [this] {
        d->stale = true;
        if (isVisible())
            reload();
    });
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
    d->open->setToolTip(tr("Identify the recording of the chosen squeeze again and look at it (Enter)"));
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
    connect(d->open, &QPushButton::clicked, this, &HistoryPage::openCurrent);
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
    connect(d->charts, &HistoryCharts::chosen, d->table, &HistoryTable::select);
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

void HistoryPage::reload()
{
    const int generation = ++d->generation;
    d->stale = false;
    d->loading = true;
    workbench().background().ask<HistoryStart>(
        this, [wanted = query()](Library& library) { return fetchStart(library, wanted); },
        [this, generation](Expected<HistoryStart> start) {
            if (generation != d->generation)
                return;
            d->loading = false;
            if (!start) {
                workbench().messages().report(start.error().describe());
                return;
            }
            d->waiting.clear();
            d->filters->setChoices(start->choices);
            const QString summary = HistoryWords::summary(start->counts);
            d->counts->setFullText(summary);
            d->counts->setVisible(!summary.isEmpty());
            d->emptyTitle->setText(start->empty ? tr("No squeezes yet") : tr("Nothing matches the filters"));
            d->emptyText->setText(
                start->empty
                    ? tr("Squeeze a part on the Inspect page, or enroll a type: every squeeze is kept here.")
                    : tr("Clear the search and the filters to see every squeeze."));
            d->detailed.clear();
            d->table->restart(std::move(start->keys), std::move(start->first));
            if (std::exchange(d->choosesFirst, false))
                d->table->selectRow(0);
            showContent();
            loadPoints();
        });
}

void HistoryPage::fetchPage()
{
    if (d->fetching || d->waiting.empty())
        return;
    while (d->waiting.size() > mostPagesWaiting) {
        d->model->forgetRequest(d->waiting.front());
        d->waiting.erase(d->waiting.begin());
    }
    const int page = d->waiting.back();
    d->waiting.pop_back();
    d->fetching = true;
    workbench().background().ask<std::vector<HistoryEntry>>(
        this, [keys = d->model->pageKeys(page)](Library& library) { return library.historyEntries(keys); },
        [this, page, generation = d->generation](Expected<std::vector<HistoryEntry>> entries) {
            d->fetching = false;
            if (!entries)
                workbench().messages().report(entries.error().describe());
            if (generation == d->generation)
                d->model->setPage(page, entries.value_or(std::vector<HistoryEntry>{}));
            fetchPage();
        });
}

void HistoryPage::loadPoints()
{
    if (!d->trend->isChecked() || d->pointsGeneration == d->generation)
        return;
    d->pointsGeneration = d->generation;
    workbench().background().ask<HistoryPoints>(
        this, [wanted = query()](Library& library) { return library.historyPoints(wanted); },
        [this, generation = d->generation](Expected<HistoryPoints> points) {
            if (generation != d->generation)
                return;
            if (!points) {
                workbench().messages().report(points.error().describe());
                return;
            }
            d->charts->setPoints(std::make_shared<HistoryPoints>(std::move(*points)),
                                 workbench().inspection().models());
            d->charts->select(d->table->currentKey());
        });
}

void HistoryPage::loadDetails()
{
    const QString key = d->table->currentKey();
    d->charts->select(key);
    if (key == d->detailed && !key.isEmpty())
        return;
    d->detailed = key;
    if (key.isEmpty()) {
        d->details->clear();
        return;
    }
    workbench().background().ask<SqueezeDetails>(
        this, [key](Library& library) { return library.squeezeDetails(key); },
        [this, key](Expected<SqueezeDetails> details) {
            if (key != d->detailed)
                return; // another one was chosen meanwhile
            if (details)
                d->details->show(*details);
            else
                workbench().messages().report(details.error().describe());
        });
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
        openStoredSqueeze(workbench(), this, entry->graspId, HistoryWords::title(*entry));
}

void HistoryPage::identifyAgain()
{
    std::vector<QString> keys = d->table->selectedKeys();
    if (keys.empty())
        return;
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
    d->work->run(recordingExport(d->table->selectedKeys(), folder), tr("Writing recordings"),
                 tr("Recordings written to %1").arg(folder));
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
