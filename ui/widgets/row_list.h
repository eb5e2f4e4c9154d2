// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTableView;

namespace gripscope {

/// Makes a table one that is read row by row, of which one is chosen: no grid, no numbers at the side, a line
/// a cell, nothing changed in place. How wide the columns are is left to the caller.
void setUpRowList(QTableView* table, int rowHeight);

} // namespace gripscope
