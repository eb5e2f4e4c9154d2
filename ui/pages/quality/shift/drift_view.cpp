// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "ui/charts/course_plot.h"
#include "ui/charts/interval_plot.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/pages/quality/shift/drift_charts.h"
#include "ui/pages/quality/shift/shift_views.h"
#include "ui/pages/quality/shift/shift_words.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollArea>
#include <QTabBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int driftRowHeight = 32, mostDriftRows = 12;
constexpr std::array<int, 4> newestChoices{100, 400, 1000, 5000};
constexpr int usualNewest = 1; // among these
constexpr std::array<std::size_t, 3> driftTabOrder{2, 1, 0};

} // namespace

DriftView::DriftView(Workbench& workbench, QWidget* parent) : QWidget(parent), m_workbench(&workbench)
{
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 0, 12);
    column->addWidget(makeVerdict(content));
    m_figures = new QWidget(content);
    auto* figures = new QVBoxLayout(m_figures);
    setSpacing(figures, 0, 12);
    QFrame* card = makeCard(m_figures);
    auto* inside = new QVBoxLayout(card);
    setSpacing(inside, 12, 0);
    m_shifts = new IntervalPlot(card);
    m_shifts->setObjectName("driftShifts");
    inside->addWidget(m_shifts);
    figures->addWidget(card);
    figures->addWidget(makeCourse(m_figures));
    figures->addWidget(makeTable(m_figures));
    column->addWidget(m_figures);
    column->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 12);
    outer->addWidget(makeHead());
    outer->addWidget(makeScroll(content, this), 1);
    m_figures->hide();
    for (QComboBox* box : {m_newest, m_gripper, m_station})
        connect(box, &QComboBox::activated, this, &DriftView::load);
    connect(m_tabs, &QTabBar::currentChanged, this, &DriftView::showCourse);
    connect(m_go, &QPushButton::clicked, this, [this] {
        if (m_look)
            m_workbench->navigator().showPage(ShiftWords::nextPage(m_look->report.cause));
    });
}

QWidget* DriftView::makeHead()
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    QPushButton* back = makeButton(tr("All studies"), u"go-previous"_s, "", box);
    back->setObjectName("driftBack");
    connect(back, &QPushButton::clicked, this, &DriftView::left);
    m_newest = new QComboBox(box);
    m_newest->setObjectName("driftNewest");
    m_newest->setAccessibleName(tr("How many inspections are looked at"));
    for (const int count : newestChoices)
        m_newest->addItem(tr("Newest %1").arg(formatCount(count)), count);
    m_newest->setCurrentIndex(usualNewest);
    m_gripper = new QComboBox(box);
    m_gripper->setObjectName("driftGripper");
    m_gripper->setAccessibleName(tr("Gripper"));
    m_gripper->addItem(tr("All grippers"), QString());
    m_station = new QComboBox(box);
    m_station->setObjectName("driftStation");
    m_station->setAccessibleName(tr("Station"));
    m_station->addItem(tr("All stations"), QString());
    row->addWidget(back);
    row->addWidget(makeLabel(tr("What moved"), "strong", box), 1);
    for (QComboBox* choice : {m_newest, m_gripper, m_station}) {
        choice->setMinimumContentsLength(8);
        choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        choice->setMaximumWidth(200);
        row->addWidget(choice);
    }
    return box;
}

QWidget* DriftView::makeVerdict(QWidget* parent)
{
    QFrame* card = makeCard(parent);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    m_cause = makeLabel({}, "title", card);
    m_cause->setObjectName("driftCause");
    m_words = makeLabel({}, "", card);
    m_words->setObjectName("driftWords");
    m_since = makeLabel({}, "strong", card);
    m_since->setObjectName("driftSince");
    m_next = makeLabel({}, "", card);
    m_next->setObjectName("driftNext");
    m_counts = makeLabel({}, "caption", card);
    m_counts->setObjectName("driftCounts");
    m_go = makeButton({}, u"go-next"_s, "primary", card);
    m_go->setObjectName("driftGo");
    for (QLabel* label : {m_cause, m_words, m_since, m_next, m_counts})
        label->setWordWrap(true);
    for (QLabel* label : {m_cause, m_since, m_words})
        column->addWidget(label);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(m_next, 1);
    row->addWidget(m_go, 0, Qt::AlignTop);
    column->addLayout(row);
    column->addWidget(m_counts);
    m_go->hide();
    return card;
}

QWidget* DriftView::makeCourse(QWidget* parent)
{
    QFrame* card = makeCard(parent);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 12, 4);
    m_tabs = new QTabBar(card);
    m_tabs->setObjectName("driftTabs");
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    for (const std::size_t quantity : driftTabOrder)
        m_tabs->addTab(ShiftWords::quantity(quantity));
    m_course = new CoursePlot(card);
    m_course->setObjectName("driftCourse");
    column->addWidget(m_tabs);
    column->addWidget(m_course);
    return card;
}

QWidget* DriftView::makeTable(QWidget* parent)
{
    QFrame* card = makeCard(parent);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 2, 0);
    m_table = new QTableWidget(0, 7, card);
    m_table->setObjectName("driftTable");
    m_table->setAccessibleName(tr("Shifts by type"));
    m_table->setHorizontalHeaderLabels({tr("Type"), tr("Squeezes"), ShiftWords::quantity(2),
                                        ShiftWords::quantity(1), ShiftWords::quantity(0), tr("By chance"),
                                        tr("Charts")});
    setUpRowList(m_table, driftRowHeight);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(5, QHeaderView::ResizeToContents);
    column->addWidget(m_table);
    return card;
}

InspectedChoice DriftView::choice() const
{
    InspectedChoice choice;
    choice.newest = m_newest->currentData().toInt();
    choice.gripperSerial = m_gripper->currentData().toString();
    choice.station = m_station->currentData().toString();
    return choice;
}

void DriftView::load()
{
    const int request = ++m_asked;
    if (!m_look)
        m_cause->setText(tr("Being read…"));
    m_workbench->background().ask<DriftMaterial>(
        this, [wanted = choice()](Library& library) { return readDriftMaterial(library, wanted); },
        [this, request](Expected<DriftMaterial> material) {
            if (request != m_asked)
                return;
            if (!material)
                return show(tl::unexpected<Error>(material.error()));
            m_workbench->background().compute<Expected<DriftLook>>(
                this, [material = *std::move(material)] { return lookForDrift(material); },
                [this, request](const Expected<DriftLook>& look) {
                    if (request == m_asked)
                        show(look);
                });
        });
}

void DriftView::offer(QComboBox* box, const QStringList& names)
{
    const QString chosen = box->currentData().toString();
    while (box->count() > 1)
        box->removeItem(1);
    for (const QString& name : names)
        box->addItem(name, name);
    if (!chosen.isEmpty() && box->findData(chosen) < 0)
        box->addItem(chosen, chosen);
    box->setCurrentIndex(std::max(0, box->findData(chosen)));
    box->setVisible(box->count() > 2 || !chosen.isEmpty());
}

void DriftView::show(const Expected<DriftLook>& look)
{
    if (!look) {
        m_look.reset();
        m_cause->setText(look.error().describe());
        for (QLabel* label : {m_words, m_since, m_next, m_counts})
            label->clear();
        m_go->hide();
        m_figures->hide();
        return;
    }
    m_look = *look;
    offer(m_gripper, m_look->inspected.grippers);
    offer(m_station, m_look->inspected.stations);
    showVerdict();
    m_figures->setVisible(!m_look->report.types.empty());
    m_shifts->setChart(DriftCharts::shifts(*m_look, places()));
    showCourse();
    showTable();
}

void DriftView::showVerdict()
{
    const DriftReport& report = m_look->report;
    const InspectedSqueezes& inspected = m_look->inspected;
    m_cause->setText(m_look->models.types.empty() ? tr("No type is approved")
                     : inspected.squeezes.empty() ? tr("No inspection to look at")
                                                  : ShiftWords::cause(report.cause));
    m_words->setText(m_look->models.types.empty()
                         ? tr("Enrol types and approve them; what is inspected then is held against them.")
                     : inspected.squeezes.empty()
                         ? tr("No inspected squeeze of an approved type is among those that are chosen.")
                         : keptTogether(described(report.words).join(u' ')));
    m_since->setText(keptTogether(described(m_look->since).join(u' ')));
    m_since->setVisible(!m_look->since.empty());
    const QString batch = m_look->change && m_look->change->before > 0
                              ? inspected.origins[std::size_t(m_look->change->before)].batch
                              : QString();
    const QString next = ShiftWords::nextStep(report, batch);
    m_next->setText(next.isEmpty() ? QString() : tr("What to do next: %1").arg(next));
    m_next->setVisible(!next.isEmpty());
    m_go->setText(ShiftWords::nextButton(report.cause));
    m_go->setVisible(!m_go->text().isEmpty());
    m_counts->setText(
        tr("Squeezes of approved types: %1. Inspections left out: %2, of no known type, not valid "
           "or void. A type is said to have moved where none has in one look of a hundred.")
            .arg(formatCount(qint64(inspected.squeezes.size())), formatCount(inspected.leftOut)));
}

QMap<QString, int> DriftView::places() const
{
    QMap<QString, int> places;
    for (const TypeRecord& type : m_workbench->inspection().types())
        places.insert(type.name, type.place);
    return places;
}

void DriftView::showCourse()
{
    if (m_look)
        m_course->setChart(DriftCharts::course(
            *m_look, driftTabOrder[std::size_t(std::max(0, m_tabs->currentIndex()))], places()));
}

void DriftView::showTable()
{
    const std::vector<TypeDrift>& types = m_look->report.types;
    const std::optional<CommonShift>& all = m_look->report.factor;
    const bool isTogether = all && types.size() > 1;
    m_table->setRowCount(int(types.size()) + (isTogether ? 1 : 0));
    const auto fill = [this](int row, const QStringList& cells) {
        for (int column = 0; column < cells.size(); ++column) {
            auto* cell = new QTableWidgetItem(cells[column]);
            cell->setToolTip(cells[column]);
            m_table->setItem(row, column, cell);
        }
    };
    const auto shifts = [](const LogVector& log, const LogMatrix& covariance) {
        QStringList cells;
        for (const std::size_t quantity : driftTabOrder) {
            const auto i = Eigen::Index(quantity);
            cells << ShiftWords::percentInterval(log(i), std::sqrt(covariance(i, i)));
        }
        return cells;
    };
    int row = 0;
    for (const TypeDrift& type : types) {
        QStringList cells{type.type, formatCount(type.squeezes)};
        cells << (type.shift ? shifts(type.shift->log, type.shift->covariance)
                             : QStringList{u"–"_s, u"–"_s, u"–"_s});
        cells << (type.shift ? formatProbability(type.shift->pValue) : u"–"_s);
        cells << (type.firstAlarm ? tr("alarm at squeeze %1").arg(formatCount(*type.firstAlarm))
                                  : tr("quiet"));
        fill(row++, cells);
    }
    if (isTogether)
        fill(row, QStringList{tr("All together"), QString()} + shifts(all->value, all->covariance) +
                      QStringList{formatProbability(all->pValue),
                                  tr("one factor fits all: %1").arg(formatProbability(all->agreement))});
    fitHeightToRows(m_table, mostDriftRows);
    m_table->setFixedHeight(m_table->maximumHeight());
}

void DriftView::focusFirst()
{
    m_newest->setFocus();
}

} // namespace gripscope
