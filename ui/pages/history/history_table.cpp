// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_figure.h"
#include "ui/charts/trend_plot.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/models/history_model.h"
#include "ui/pages/history/history_parts.h"
#include "ui/pages/page_state.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

using TableColumn = HistoryModel::Column;

namespace {

/// A selection of more rows than these is not carried over to the next list: finding each takes its time.
constexpr qint64 mostKept = 200;

const std::initializer_list<TableColumn> firstColumns{
    TableColumn::Number,   TableColumn::Time,  TableColumn::Outcome, TableColumn::Validity,
    TableColumn::Type,     TableColumn::Mass,  TableColumn::Damping, TableColumn::Stiffness,
    TableColumn::Operator, TableColumn::Device};

} // namespace

HistoryTable::HistoryTable(HistoryModel* model, QWidget* parent)
    : QTableView(parent), m_model(model), m_columns(new QMenu(this))
{
    setObjectName("historyTable");
    setModel(model);
    setItemDelegate(new HistoryDelegate(this));
    setSelectionBehavior(SelectRows);
    setSelectionMode(ExtendedSelection);
    setShowGrid(false);
    setFrameShape(NoFrame);
    setTabKeyNavigation(false);
    setHorizontalScrollMode(ScrollPerPixel);
    setWordWrap(false);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed); // measured rows would be all of them
    verticalHeader()->setDefaultSectionSize(metrics::touchTarget);
    setStyleSheet(u"QTableView::item { padding: 0 4px; }"_s);
    setAccessibleName(tr("Squeezes"));
    buildHeader();
    buildColumnsMenu();
}

void HistoryTable::buildHeader()
{
    QHeaderView* header = horizontalHeader();
    header->setStyleSheet(u"QHeaderView::section { padding: 8px 6px; }"_s); // in line with the cells
    header->setHighlightSections(false);
    header->setSectionsMovable(true);
    header->setStretchLastSection(true);
    header->setSortIndicator(int(TableColumn::Time), Qt::DescendingOrder);
    header->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header, &QHeaderView::customContextMenuRequested, this,
            [this, header](const QPoint& at) { m_columns->popup(header->mapToGlobal(at)); });
    // What counts most comes first where nobody sorted yet: the newest, the largest.
    header->setSortIndicatorClearable(false);
    setSortingEnabled(true);
}

void HistoryTable::buildColumnsMenu()
{
    rememberColumns(horizontalHeader());
    for (int i = 0; i < int(historyColumns().size()); ++i) {
        QAction* action = m_columns->addAction(HistoryModel::columnName(TableColumn(i)));
        action->setCheckable(true);
        setColumnHidden(i, std::find(firstColumns.begin(), firstColumns.end(), TableColumn(i)) ==
                               firstColumns.end());
        action->setChecked(!isColumnHidden(i));
        connect(action, &QAction::triggered, this, [this, i](bool on) {
            setColumnHidden(i, !on);
            fitColumns();
        });
    }
    // They may have been chosen in an earlier run.
    connect(m_columns, &QMenu::aboutToShow, this, [this] {
        for (int i = 0; i < int(historyColumns().size()); ++i)
            m_columns->actions()[i]->setChecked(!isColumnHidden(i));
    });
}

/// The header's own hint leaves room for the sign of sorting in every column.
int HistoryTable::titleWidth(int column) const
{
    constexpr int padding = 16, sign = 20;
    QFont bold = horizontalHeader()->font();
    bold.setWeight(QFont::DemiBold);
    int wide = 0;
    for (const QString& line : m_model->headerData(column, Qt::Horizontal).toString().split(u'\n'))
        wide = std::max(wide, QFontMetrics(bold).horizontalAdvance(line));
    return wide + padding + (horizontalHeader()->sortIndicatorSection() == column ? sign : 0);
}

namespace {

/// Every outcome has its room: the first part may be inspected after the columns were fitted.
int widestOutcome(const QFontMetrics& font)
{
    constexpr int signAndAir = 48;
    int wide = 0;
    for (const InspectionOutcome outcome : allInspectionOutcomes)
        for (const bool expected : {true, false})
            wide = std::max(wide, font.horizontalAdvance(outcomeWord(outcome, false, expected)));
    return wide + signAndAir;
}

} // namespace

void HistoryTable::fitColumns()
{
    // By the rows in view: all of them would be asked for otherwise.
    for (int column = 0; column < int(historyColumns().size()); ++column)
        if (!isColumnHidden(column))
            setColumnWidth(
                column,
                std::max({sizeHintForColumn(column), titleWidth(column),
                          TableColumn(column) == TableColumn::Outcome ? widestOutcome(fontMetrics()) : 0}));
}

std::vector<std::pair<int, int>> HistoryTable::selectedRows() const
{
    std::vector<std::pair<int, int>> stretches;
    for (const QItemSelectionRange& range : selectionModel()->selection())
        stretches.emplace_back(range.top(), range.bottom());
    std::sort(stretches.begin(), stretches.end());
    std::vector<std::pair<int, int>> apart; // a row can be in two of them
    for (const auto& [top, bottom] : stretches)
        if (!apart.empty() && top <= apart.back().second)
            apart.back().second = std::max(apart.back().second, bottom);
        else
            apart.emplace_back(top, bottom);
    return apart;
}

qint64 HistoryTable::selectedCount() const
{
    qint64 count = 0;
    for (const auto& [top, bottom] : selectedRows())
        count += bottom - top + 1;
    return count;
}

std::optional<std::vector<QString>> HistoryTable::selectedKeys() const
{
    if (selectedCount() > qint64(HistoryList::mostCollected))
        return {};
    std::vector<QString> keys;
    for (const auto& [top, bottom] : selectedRows())
        for (int row = top; row <= bottom; ++row) {
            keys.push_back(m_model->key(row));
            if (keys.back().isEmpty())
                return {};
        }
    return keys;
}

bool HistoryTable::severalSelected() const
{
    return selectedCount() > 1;
}

QString HistoryTable::currentKey() const
{
    const QModelIndex current = currentIndex();
    return current.isValid() ? m_model->key(current.row()) : QString();
}

void HistoryTable::select(int row)
{
    if (row < 0 || row >= m_model->rowCount())
        return;
    selectRow(row);
    scrollTo(m_model->index(row, 0), PositionAtCenter);
}

QHash<QString, int> HistoryTable::rowsToKeep() const
{
    QHash<QString, int> rows;
    const auto keep = [&](int row) {
        if (const QString key = m_model->key(row); !key.isEmpty())
            rows.insert(key, row);
    };
    if (selectedCount() <= mostKept)
        for (const auto& [top, bottom] : selectedRows())
            for (int row = top; row <= bottom; ++row)
                keep(row);
    if (currentIndex().isValid())
        keep(currentIndex().row());
    return rows;
}

void HistoryTable::restart(std::shared_ptr<const HistoryList> list, std::vector<HistoryEntry> first,
                           const QHash<QString, int>& rows)
{
    std::vector<QString> selected;
    if (selectedCount() <= mostKept)
        selected = selectedKeys().value_or(std::vector<QString>{});
    const QString current = currentKey();
    const int scrolled = verticalScrollBar()->value();
    m_restarting = true;
    m_model->restart(std::move(list), std::move(first));
    reselect(selected, current, rows);
    m_restarting = false;
    if (!m_fitted && m_model->rowCount() > 0) {
        fitColumns();
        m_fitted = true;
    }
    verticalScrollBar()->setValue(scrolled);
    emit chosen();
}

void HistoryTable::reselect(const std::vector<QString>& keys, const QString& current,
                            const QHash<QString, int>& rows)
{
    const auto rowOf = [&](const QString& key) {
        const auto known = rows.constFind(key);
        return known != rows.constEnd() && *known < m_model->rowCount() ? *known : m_model->rowOf(key);
    };
    QItemSelection selection;
    for (const QString& key : keys)
        if (const int row = rowOf(key); row >= 0)
            selection.select(m_model->index(row, 0), m_model->index(row, int(historyColumns().size()) - 1));
    selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    if (const int row = current.isEmpty() ? -1 : rowOf(current); row >= 0)
        selectionModel()->setCurrentIndex(m_model->index(row, 0), QItemSelectionModel::NoUpdate);
}

void HistoryTable::selectionChanged(const QItemSelection& selected, const QItemSelection& deselected)
{
    QTableView::selectionChanged(selected, deselected);
    if (!m_restarting)
        emit chosen();
}

void HistoryTable::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    QTableView::currentChanged(current, previous);
    if (!m_restarting)
        emit chosen();
}

/// The signs of the types with their names, as many as there is room for.
class HistoryCharts::Legend : public QWidget {
public:
    Legend() { setFixedHeight(metrics::touchTarget); }
    const TrendContent* content = nullptr;

protected:
    void paintEvent(QPaintEvent*) override
    {
        if (!content || !content->points)
            return;
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        paintTypeLegend(painter, *content, rect(), Theme::instance().tokens());
    }
};

HistoryCharts::HistoryCharts(QWidget* parent)
    : QWidget(parent), m_view(new TrendView), m_legend(new Legend), m_byTime(makeButton(tr("Over time"))),
      m_byPlace(makeButton(tr("One after another"))), m_note(makeLabel({}, "second"))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, metrics::step, metrics::insideControl);
    auto* line = new QHBoxLayout;
    line->setSpacing(metrics::step);
    line->addWidget(m_legend, 1);
    auto* group = new QButtonGroup(this);
    for (QPushButton* button : {m_byTime, m_byPlace}) {
        button->setCheckable(true);
        group->addButton(button);
        line->addWidget(button);
    }
    m_byTime->setChecked(true);
    m_byPlace->setObjectName("historyByPlace");
    column->addLayout(line);
    column->addWidget(m_view, 1);
    m_note->setWordWrap(true);
    column->addWidget(m_note);
    refreshNote();
    connect(m_byTime, &QPushButton::toggled, this, [this] { refresh(); });
    connect(m_view, &TrendView::pointChosen, this, [this](qsizetype place) {
        if (m_points && std::size_t(place) < m_points->keys.size())
            emit chosen(m_points->keys.at(std::size_t(place)));
    });
    connect(&Theme::instance(), &Theme::changed, m_legend, qOverload<>(&QWidget::update));
}

void HistoryCharts::setPoints(std::shared_ptr<const HistoryPoints> points, const TypeModels& models,
                              std::vector<GateIntervals> gates)
{
    m_points = std::move(points);
    m_models = models;
    m_gates = std::move(gates);
    refresh();
    refreshNote();
}

void HistoryCharts::refreshNote()
{
    QString note = tr("Bands: where 95 % of the squeezes of an enrolled type lie. Bars: 95 % intervals "
                      "of the squeeze. Drag to zoom, double click to see everything.");
    if (m_view->content().gated())
        note = trendGateNote() + u' ' + note;
    if (m_points && m_points->oneIn > 1)
        note = tr("One inspection in %1 is drawn, by its number: a single outlier may be missing. Narrow the "
                  "dates to see every one.")
                   .arg(formatCount(m_points->oneIn)) +
               u' ' + note;
    m_note->setText(note);
}

void HistoryCharts::refresh()
{
    if (!m_points)
        return;
    m_view->setContent(trendContent(m_points, m_models, m_byTime->isChecked(), m_gates));
    m_legend->content = &m_view->content();
    m_legend->update();
}

void HistoryCharts::select(const QString& key)
{
    m_view->setSelected(m_points && !key.isEmpty() ? m_points->keys.find(key) : std::nullopt);
}

} // namespace gripscope
