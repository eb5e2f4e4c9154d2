// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTableView;

namespace gripscope {

/// Makes a table one that is read row by row, of which one is chosen: no grid, no numbers at the side, a line
/// a cell, nothing changed in place. How wide the columns are is left to the caller.
void setUpRowList(QTableView* table, int rowHeight);

/// Lets sentences go on in a next line, each row as high as its lines at every width.
void letRowsWrap(QTableView* table);

/// Gives each column that is shown the width of its words, and what is left of the table's width in equal
/// parts to all but the first, which counts the rows. To be called when words or width change.
void spreadColumns(QTableView* table);

/// Makes a table no higher than its rows, or than `most` of them: it shares a place with something that uses
/// what is left. To be called when the rows change.
void fitHeightToRows(QTableView* table, int most);

} // namespace gripscope
