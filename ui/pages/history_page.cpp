// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/history_page.h"

#include "ui/models/history_csv.h"
#include "ui/models/history_delegate.h"
#include "ui/models/history_model.h"
#include "ui/pages/fit_page_open.h"
#include "ui/pages/history_page_examples.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_format.h"
#include "ui/workbench.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSaveFile>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>

namespace gripscope {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

struct HistoryPage::Private {
    HistoryModel* model = nullptr;
    QTableView* table = nullptr;
    QStackedWidget* stack = nullptr;
    QLineEdit* text = nullptr;
    QComboBox* verdict = nullptr;
    QPushButton* open = nullptr;
    QPushButton* save = nullptr;
    QLabel* counts = nullptr;
    QLabel* emptyTitle = nullptr;
    QLabel* emptyText = nullptr;
    QTimer typing; ///< a filter is applied once a person stops typing
    int generation = 0;
    bool stale = true, loading = false;
    ExampleInspections* examples = nullptr;
};

namespace {

/// What one visit to the library brings back.
struct HistoryStart {
    InspectionCounts counts;
    qint64 matching = 0;
    std::vector<InspectionRecord> page;
};

Expected<HistoryStart> fetchStart(Library& library, const HistoryFilter& filter)
{
    HistoryStart start;
    if (const auto counts = library.inspectionCounts())
        start.counts = *counts;
    else
        return tl::unexpected<Error>(counts.error());
    if (const auto matching = library.countInspections(filter))
        start.matching = *matching;
    else
        return tl::unexpected<Error>(matching.error());
    auto page = library.inspections(filter);
    if (!page)
        return tl::unexpected<Error>(page.error());
    start.page = std::move(*page);
    return start;
}

} // namespace

HistoryPage::HistoryPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    d->model = new HistoryModel(this);
    d->typing.setSingleShot(true);
    d->typing.setInterval(250ms);
    connect(&d->typing, &QTimer::timeout, this, [this] { reload(); });
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 2 * metrics::step, metrics::step + 4);
    column->addWidget(buildBar());
    d->counts = makeLabel({}, "second");
    column->addWidget(d->counts);
    buildTable();
    auto* empty = new QWidget;
    auto* words = new QVBoxLayout(empty);
    d->emptyTitle = makeLabel({}, "title");
    d->emptyText = makeLabel({}, "second");
    words->addStretch();
    words->addWidget(d->emptyTitle, 0, Qt::AlignHCenter);
    words->addWidget(d->emptyText, 0, Qt::AlignHCenter);
    words->addStretch();
    d->stack = new QStackedWidget;
    d->stack->setStyleSheet(u"QStackedWidget { background: transparent; }"_s);
    d->stack->addWidget(d->table);
    d->stack->addWidget(empty);
    auto* card = makeCard();
    auto* cardLayout = new QVBoxLayout(card);
    cardLayout->setContentsMargins(1, 1, 1, 1);
    cardLayout->addWidget(d->stack);
    column->addWidget(card, 1);

    connect(d->model, &HistoryModel::pageAsked, this, [this](int offset) { fetch(offset); });
    connect(&bench, &Workbench::libraryChanged, this, [this] {
        d->stale = true;
        if (isVisible())
            reload();
    });
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

QWidget* HistoryPage::buildBar()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    d->text = new QLineEdit;
    d->text->setPlaceholderText(tr("Filter by type, operator or source"));
    d->text->setAccessibleName(tr("Filter text"));
    d->text->setClearButtonEnabled(true);
    d->verdict = new QComboBox;
    d->verdict->addItem(tr("All verdicts"));
    d->verdict->addItem(tr("A type named"), int(VerdictKind::Type));
    d->verdict->addItem(tr("Unknown"), int(VerdictKind::Unknown));
    d->verdict->addItem(tr("Inconclusive"), int(VerdictKind::Inconclusive));
    d->verdict->addItem(tr("Not valid"), int(VerdictKind::Invalid));
    d->verdict->setAccessibleName(tr("Verdicts to show"));
    d->open = makeButton(tr("Open in Fit"), u"labplot-xy-fit-curve"_s);
    d->open->setToolTip(tr("Identify the stored recording of the selected row again (Enter)"));
    d->save = makeButton(tr("Export CSV…"), u"document-export"_s);
    d->save->setToolTip(tr("Write all rows that match the filters to a file"));
    line->addWidget(d->text, 1);
    line->addWidget(d->verdict);
    line->addWidget(d->open);
    line->addWidget(d->save);
    connect(d->text, &QLineEdit::textChanged, this, [this] { d->typing.start(); });
    connect(d->verdict, &QComboBox::currentIndexChanged, this, [this] { reload(); });
    connect(d->open, &QPushButton::clicked, this, [this] { openRow(d->table->currentIndex()); });
    connect(d->save, &QPushButton::clicked, this, [this] { chooseExport(); });
    return bar;
}

void HistoryPage::buildTable()
{
    d->table = new QTableView;
    d->table->setModel(d->model);
    d->table->setItemDelegate(new HistoryDelegate(this));
    d->table->setSelectionBehavior(QAbstractItemView::SelectRows);
    d->table->setSelectionMode(QAbstractItemView::SingleSelection);
    d->table->setShowGrid(false);
    d->table->setFrameShape(QFrame::NoFrame);
    d->table->setTabKeyNavigation(false);
    d->table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    d->table->verticalHeader()->hide();
    d->table->verticalHeader()->setDefaultSectionSize(metrics::touchTarget);
    d->table->setStyleSheet(u"QTableView::item { padding: 0 4px; }"_s);
    QHeaderView* header = d->table->horizontalHeader();
    header->setStyleSheet(u"QHeaderView::section { padding: 8px 6px; }"_s); // in line with the cells
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setStretchLastSection(true);
    d->table->setAccessibleName(tr("Inspections, newest first"));
    connect(d->table, &QTableView::activated, this, [this](const QModelIndex& index) { openRow(index); });
    connect(d->table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { d->open->setEnabled(now.isValid()); });
}

void HistoryPage::setActive(bool active)
{
    if (active && d->stale)
        reload();
}

HistoryFilter HistoryPage::filter() const
{
    HistoryFilter result;
    result.text = d->text->text().trimmed();
    if (const QVariant verdict = d->verdict->currentData(); verdict.isValid())
        result.verdict = VerdictKind(verdict.toInt());
    result.limit = HistoryModel::pageSize;
    return result;
}

void HistoryPage::reload()
{
    const int generation = ++d->generation;
    d->stale = false;
    d->loading = true;
    workbench().ask<HistoryStart>(
        this, [wanted = filter()](Library& library) { return fetchStart(library, wanted); },
        [this, generation](Expected<HistoryStart> start) {
            if (generation != d->generation)
                return;
            d->loading = false;
            if (!start) {
                workbench().report(start.error().describe());
                return;
            }
            d->model->restart(start->matching, std::move(start->page));
            showCounts(start->counts, start->matching);
        });
}

void HistoryPage::fetch(int offset)
{
    HistoryFilter wanted = filter();
    wanted.offset = offset;
    workbench().ask<std::vector<InspectionRecord>>(
        this, [wanted](Library& library) { return library.inspections(wanted); },
        [this, offset, generation = d->generation](Expected<std::vector<InspectionRecord>> page) {
            if (generation != d->generation)
                return;
            if (!page)
                workbench().report(page.error().describe());
            d->model->append(offset, page.value_or(std::vector<InspectionRecord>{}));
        });
}

void HistoryPage::showCounts(const InspectionCounts& counts, qint64 matching)
{
    const auto share = [&](qint64 count, const QString& name) {
        return count > 0 ? u" · "_s + u"%1 %2"_s.arg(formatCount(count), name) : QString();
    };
    QString text = tr("%1 inspected").arg(formatCount(counts.total));
    if (counts.total > 0)
        text +=
            u" · "_s +
            tr("%1 as expected").arg(formatPercent(100.0 * double(counts.asExpected) / double(counts.total)));
    text += share(counts.otherType, tr("other type")) + share(counts.unknown, tr("unknown")) +
            share(counts.inconclusive, tr("inconclusive")) + share(counts.invalid, tr("not valid"));
    if (matching != counts.total)
        text += u" · "_s + tr("%1 match the filters").arg(formatCount(matching));
    d->counts->setText(text);
    d->counts->setVisible(counts.total > 0);
    d->stack->setCurrentIndex(matching > 0 ? 0 : 1);
    d->open->setEnabled(d->table->currentIndex().isValid());
    d->save->setEnabled(matching > 0);
    d->emptyTitle->setText(counts.total > 0 ? tr("Nothing matches the filters") : tr("No inspections yet"));
    d->emptyText->setText(counts.total > 0
                              ? tr("Clear the text or choose all verdicts.")
                              : tr("Squeeze a part on the Inspect page: every verdict is kept here."));
}

void HistoryPage::openRow(const QModelIndex& index)
{
    if (!index.isValid())
        return;
    const InspectionRecord& record = d->model->record(index.row());
    openStoredSqueeze(workbench(), this, record.graspId, tr("Inspection %1").arg(record.number));
}

void HistoryPage::chooseExport()
{
    auto* dialog = new QFileDialog(this, tr("Export inspections"), QString(), tr("CSV (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"csv"_s);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { exportTo(file); });
    dialog->open();
}

void HistoryPage::exportTo(const QString& file)
{
    workbench().ask<void>(
        this,
        [file, wanted = filter()](Library& library) -> Expected<void> {
            const Expected<QByteArray> csv = historyCsv(library, wanted);
            if (!csv)
                return tl::unexpected<Error>(csv.error());
            QSaveFile out(file);
            if (!out.open(QIODevice::WriteOnly) || out.write(*csv) != csv->size() || !out.commit())
                return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
            return {};
        },
        [this, file](Expected<void> done) {
            workbench().report(done ? tr("Inspections written to %1").arg(file) : done.error().describe());
        });
}

void HistoryPage::prepareTour()
{
    d->examples = new ExampleInspections(workbench(), this);
    connect(d->examples, &ExampleInspections::finished, this, [this] { reload(); });
    d->examples->start();
}

bool HistoryPage::tourReady() const
{
    return !d->loading && d->examples && !d->examples->busy() && d->model->rowCount() > 0;
}

} // namespace gripscope
