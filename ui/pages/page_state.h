// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

class QHeaderView;
class QWidget;

namespace gripscope {

/// Marks a combo box, a check box or a checkable button whose choice belongs to how a person arranged the
/// page: it is found again at the next start. It needs an object name.
void rememberChoice(QWidget* widget);

/// Marks a table whose columns a person chooses: which are hidden is found again, too.
void rememberColumns(QHeaderView* header);

/// How a person arranged a page: splitters, widths and sorting of its tables (of those with an object name)
/// and marked choices.
[[nodiscard]] QJsonObject arrangementOf(const QWidget& page);
/// Puts back what fits the page as it is now; whatever does not is left as it is. Columns are as wide as the
/// words of one language need: in another one, `withWidths` is false.
void restoreArrangement(QWidget& page, const QJsonObject& arrangement, bool withWidths = true);

/// What a person typed on a page and did not hand in yet, for another window of this same run; what of it
/// finds its field there comes back. Quantities are carried over in SI: the other window may show them in
/// another unit.
[[nodiscard]] QJsonObject inputOf(const QWidget& page);
void restoreInput(QWidget& page, const QJsonObject& input);

} // namespace gripscope
