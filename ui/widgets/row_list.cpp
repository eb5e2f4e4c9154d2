// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/row_list.h"

#include <QHeaderView>
#include <QTableView>

#include <algorithm>

namespace gripscope {

void setUpRowList(QTableView* table, int rowHeight)
{
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(rowHeight);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void spreadColumns(QTableView* table)
{
    int left = table->viewport()->width();
    int spread = -1;
    for (int column = 0; column < table->model()->columnCount(); ++column) {
        if (table->isColumnHidden(column))
            continue;
        table->resizeColumnToContents(column);
        left -= table->columnWidth(column);
        ++spread;
    }
    for (int column = 1; column < table->model()->columnCount() && spread > 0; ++column) {
        if (table->isColumnHidden(column))
            continue;
        const int share = std::max(0, left) / spread--;
        table->setColumnWidth(column, table->columnWidth(column) + share);
        left -= share;
    }
}

void fitHeightToRows(QTableView* table, int most)
{
    constexpr int frames = 6; // the style sheet's around what has the focus, and thicker lines of a theme
    table->ensurePolished();
    table->horizontalHeader()->ensurePolished();
    const int rows = std::clamp(table->model()->rowCount(), 1, most);
    table->setMaximumHeight(table->horizontalHeader()->sizeHint().height() +
                            rows * table->verticalHeader()->defaultSectionSize() + frames);
}

} // namespace gripscope
