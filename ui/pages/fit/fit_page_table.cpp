// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page_table.h"

#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace gripscope {

QTableView* makePanelTable(QAbstractItemModel* model)
{
    auto* table = new QTableView;
    table->setModel(model);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setShowGrid(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setTabKeyNavigation(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setMinimumSectionSize(20);
    QHeaderView* header = table->horizontalHeader();
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(0, QHeaderView::Stretch);
    header->setMinimumSectionSize(40);
    // What breaks in a narrow column takes more lines there; once all columns have their widths.
    QObject::connect(
        header, &QHeaderView::sectionResized, table,
        [table](int column) {
            if (column == 0)
                fitPanelTable(table);
        },
        Qt::QueuedConnection);
    // As much air as the delegates leave.
    header->setStyleSheet(QStringLiteral("QHeaderView::section { padding: 4px 5px; }"));
    return table;
}

void addCopyAction(QTableView* table, std::function<QString()> text)
{
    auto* copy = new QAction(QCoreApplication::translate("gripscope::FitPage", "Copy table"), table);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    QObject::connect(copy, &QAction::triggered, table,
                     [text = std::move(text)] { QGuiApplication::clipboard()->setText(text()); });
    table->addAction(copy);
    table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void fitPanelTable(QTableView* table)
{
    table->resizeRowsToContents();
    int height = table->horizontalHeader()->sizeHint().height() + 4;
    for (int row = 0; row < table->model()->rowCount(); ++row)
        height += table->rowHeight(row);
    table->setFixedHeight(height);
}

QGridLayout* makeFactGrid()
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * metrics::step);
    grid->setVerticalSpacing(metrics::insideControl);
    grid->setColumnStretch(1, 1);
    return grid;
}

void fillFacts(QGridLayout* grid, const std::vector<Fact>& facts)
{
    while (QLayoutItem* item = grid->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const Fact& fact : facts) {
        const int at = grid->rowCount();
        auto* name = makeLabel(fact.name, "second");
        name->setWordWrap(true); // where the panel has the width it stays one line
        auto* text = makeLabel(fact.text, fact.number ? "strong" : "");
        text->setWordWrap(!fact.number);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        text->setAccessibleName(u"%1: %2"_s.arg(fact.name, fact.text));
        const Qt::Alignment alignment = fact.number ? Qt::AlignBaseline : Qt::AlignTop;
        grid->addWidget(name, at, 0, alignment);
        grid->addWidget(text, at, 1, alignment);
    }
}

} // namespace gripscope
