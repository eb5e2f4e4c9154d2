// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/inspector/inspector_tabs.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QProgressBar>
#include <QTableWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

QTableWidget* makeFactTable(const QStringList& headers, QWidget* parent)
{
    auto* table = new QTableWidget(0, static_cast<int>(headers.size()), parent);
    table->setHorizontalHeaderLabels(headers);
    table->horizontalHeader()->setStretchLastSection(true);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(32);
    table->setShowGrid(false);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    return table;
}

void addFacts(QTableWidget* table, const QStringList& cells)
{
    const int row = table->rowCount();
    table->insertRow(row);
    for (int column = 0; column < cells.size(); ++column)
        table->setItem(row, column, new QTableWidgetItem(cells[column]));
}

SelfTestTab::SelfTestTab(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_test(workbench.connection())
{
    m_start = makeButton(tr("Test the gripper"), {}, "primary", this);
    m_start->setObjectName("startSelfTest");
    connect(m_start, &QPushButton::clicked, this, &SelfTestTab::start);
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Self-test"));
    m_progress->setFixedWidth(160);
    m_progress->hide();
    m_verdict = makeLabel(
        tr("Two seconds of listening, then a stop. Nothing moves; the gripper is disarmed at the end."),
        "second", this);
    m_verdict->setObjectName("selfTestVerdict");
    m_verdict->setWordWrap(true);
    m_table = makeFactTable({tr("Test"), tr("Found"), tr("Allowed"), tr("What to do")}, this);
    m_table->setObjectName("selfTestLines");
    m_table->setAccessibleName(tr("Self-test"));
    letRowsWrap(m_table);
    m_table->setColumnWidth(0, 200);
    m_table->setColumnWidth(1, 232);
    m_table->setColumnWidth(2, 200);

    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(m_start);
    row->addWidget(m_progress);
    row->addWidget(m_verdict, 1);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    column->addLayout(row);
    column->addWidget(m_table, 1);
    connect(&workbench, &Workbench::ticked, this, &SelfTestTab::follow);
}

void SelfTestTab::start()
{
    if (m_workbench->busyWithSqueeze())
        return;
    if (const Expected<void> started = m_test.start(); !started)
        return m_workbench->messages().report(started.error().describe());
    m_table->setRowCount(0);
    m_verdict->setText(tr("Listening…"));
}

void SelfTestTab::follow()
{
    const SelfTest::State before = m_test.state();
    m_test.poll();
    const bool busy =
        m_test.state() == SelfTest::State::Listening || m_test.state() == SelfTest::State::Stopping;
    m_progress->setVisible(busy);
    m_progress->setValue(static_cast<int>(100 * m_test.progress()));
    m_start->setEnabled(!busy);
    if (before != m_test.state() && m_test.state() == SelfTest::State::Done)
        showLines();
}

void SelfTestTab::showLines()
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_verdict->setText(m_test.passed() ? tr("Nothing wrong was found.")
                                       : tr("Something is wrong: see the lines with a cross."));
    m_table->setRowCount(0);
    for (const SelfTestLine& line : m_test.lines()) {
        addFacts(m_table, {line.name, line.figure, line.limit, line.advice});
        QTableWidgetItem* item = m_table->item(m_table->rowCount() - 1, 0);
        const bool passed = line.outcome == SelfTestLine::Outcome::Passed;
        const bool failed = line.outcome == SelfTestLine::Outcome::Failed;
        item->setIcon(Theme::instance().icon(passed   ? u"dialog-ok"_s
                                             : failed ? u"dialog-cancel"_s
                                                      : u"dialog-information"_s,
                                             passed   ? tokens.asExpected
                                             : failed ? tokens.notValid
                                                      : tokens.secondText));
        item->setData(Qt::AccessibleTextRole, u"%1: %2"_s.arg(line.name, passed   ? tr("passed")
                                                                         : failed ? tr("failed")
                                                                                  : tr("not tested")));
    }
}

} // namespace gripscope
