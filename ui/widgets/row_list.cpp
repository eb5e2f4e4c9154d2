// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/row_list.h"

#include <QApplication>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTableView>

#include <algorithm>

namespace gripscope {

namespace {

/// Measures the lines of a cell in the width they are painted in. Qt takes that of the whole cell, though the
/// style sheet's padding is then no place for words: the last line of some widths would end in dots.
class WrappedText : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QStyleOptionViewItem cell = option;
        initStyleOption(&cell, index);
        const QWidget* widget = option.widget;
        const QStyle* style = widget ? widget->style() : QApplication::style();
        const QRect words = style->subElementRect(QStyle::SE_ItemViewItemText, &cell, widget);
        cell.rect.setWidth(std::max(1, words.width()));
        return QStyledItemDelegate::sizeHint(cell, index);
    }
};

} // namespace

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

void letRowsWrap(QTableView* table)
{
    table->setWordWrap(true);
    table->setItemDelegate(new WrappedText(table));
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
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
