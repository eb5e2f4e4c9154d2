// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_plot.h"
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
constexpr std::size_t mostKept = 200;

const std::initializer_list<TableColumn> firstColumns{
    TableColumn::Number,    TableColumn::Time,     TableColumn::Outcome,
    TableColumn::Type,      TableColumn::Mass,     TableColumn::Damping,
    TableColumn::Stiffness, TableColumn::Operator, TableColumn::Device};

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

void HistoryTable::fitColumns()
{
    // By the rows in view: all of them would be asked for otherwise.
    for (int column = 0; column < int(historyColumns().size()); ++column)
        if (!isColumnHidden(column))
            setColumnWidth(column, std::max(sizeHintForColumn(column), titleWidth(column)));
}

std::vector<QString> HistoryTable::selectedKeys() const
{
    std::vector<int> rows;
    for (const QItemSelectionRange& range : selectionModel()->selection())
        for (int row = range.top(); row <= range.bottom(); ++row)
            rows.push_back(row);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    std::vector<QString> keys;
    for (const int row : rows)
        keys.push_back(m_model->key(row));
    return keys;
}

QString HistoryTable::currentKey() const
{
    const QModelIndex current = currentIndex();
    return current.isValid() ? m_model->key(current.row()) : QString();
}

void HistoryTable::select(const QString& key)
{
    const int row = m_model->rowOf(key);
    if (row < 0)
        return;
    selectRow(row);
    scrollTo(m_model->index(row, 0), PositionAtCenter);
}

void HistoryTable::restart(HistoryKeys keys, std::vector<HistoryEntry> first)
{
    std::vector<QString> selected = selectedKeys();
    if (selected.size() > mostKept)
        selected.clear();
    const QString current = currentKey();
    const int scrolled = verticalScrollBar()->value();
    m_restarting = true;
    m_model->restart(std::move(keys), std::move(first));
    reselect(selected, current);
    m_restarting = false;
    if (!m_fitted && m_model->rowCount() > 0) {
        fitColumns();
        m_fitted = true;
    }
    verticalScrollBar()->setValue(scrolled);
    emit chosen();
}

void HistoryTable::reselect(const std::vector<QString>& keys, const QString& current)
{
    QItemSelection selection;
    for (const QString& key : keys)
        if (const int row = m_model->rowOf(key); row >= 0)
            selection.select(m_model->index(row, 0), m_model->index(row, int(historyColumns().size()) - 1));
    selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    if (const int row = current.isEmpty() ? -1 : m_model->rowOf(current); row >= 0)
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
      m_byPlace(makeButton(tr("One after another")))
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
    QLabel* note =
        makeLabel(tr("Bands: where 95 % of the squeezes of an enrolled type lie. Bars: 95 % intervals "
                     "of the squeeze. Drag to zoom, double click to see everything."),
                  "second");
    note->setWordWrap(true);
    column->addWidget(note);
    connect(m_byTime, &QPushButton::toggled, this, [this] { refresh(); });
    connect(m_view, &TrendView::pointChosen, this, [this](qsizetype place) {
        if (m_points && std::size_t(place) < m_points->keys.size())
            emit chosen(m_points->keys.at(std::size_t(place)));
    });
    connect(&Theme::instance(), &Theme::changed, m_legend, qOverload<>(&QWidget::update));
}

void HistoryCharts::setPoints(std::shared_ptr<const HistoryPoints> points, const TypeModels& models)
{
    m_points = std::move(points);
    m_models = models;
    refresh();
}

void HistoryCharts::refresh()
{
    if (!m_points)
        return;
    m_view->setContent(trendContent(m_points, m_models, m_byTime->isChecked()));
    m_legend->content = &m_view->content();
    m_legend->update();
}

void HistoryCharts::select(const QString& key)
{
    m_view->setSelected(m_points && !key.isEmpty() ? m_points->keys.find(key) : std::nullopt);
}

} // namespace gripscope
