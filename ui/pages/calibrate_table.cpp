// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate_table.h"

#include "ui/widgets/row_list.h"

#include <QHeaderView>
#include <QTableView>

namespace gripscope {

QTableView* makeCalibrationTable(QAbstractItemModel& model, QWidget* parent)
{
    auto* table = new QTableView(parent);
    table->setModel(&model);
    setUpRowList(table, 32);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

} // namespace gripscope
