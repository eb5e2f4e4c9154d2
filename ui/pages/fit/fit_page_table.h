// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/format/fact.h"

#include <QString>

#include <functional>
#include <vector>

class QAbstractItemModel;
class QGridLayout;
class QTableView;

namespace gripscope {

/// A table for the narrow third of the Fit page: rows selectable, as wide as its place with the first column
/// taking what is left, no scroll bars of its own.
[[nodiscard]] QTableView* makePanelTable(QAbstractItemModel* model);
/// "Copy table" by Ctrl+C and in the table's context menu.
void addCopyAction(QTableView* table, std::function<QString()> text);
/// As high as its rows, so that the panel around it does the scrolling.
void fitPanelTable(QTableView* table);

/// Two columns, for facts.
[[nodiscard]] QGridLayout* makeFactGrid();
/// In place of what is there.
void fillFacts(QGridLayout* grid, const std::vector<Fact>& facts);

} // namespace gripscope
