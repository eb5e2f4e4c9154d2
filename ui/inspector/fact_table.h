// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QTableWidget;
class QWidget;

namespace gripscope {

/// A quiet table of words, whose last column takes what width there is.
[[nodiscard]] QTableWidget* makeFactTable(const QStringList& headers, QWidget* parent);
void addFacts(QTableWidget* table, const QStringList& cells);

} // namespace gripscope
