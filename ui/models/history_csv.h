// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"

#include <QByteArray>

#include <vector>

namespace gripscope {

/// Inspections as CSV for a spreadsheet or a script: UTF-8, LF, C locale, times in UTC, numbers in their
/// shortest form that reads back the same, m, b and k in the squeeze's own units, which stand beside them.
[[nodiscard]] QByteArray toCsv(const std::vector<InspectionRecord>& inspections);

/// The same for every inspection that `filter` lets through; its limit and offset do not matter. On the
/// library's thread.
[[nodiscard]] Expected<QByteArray> historyCsv(Library& library, HistoryFilter filter);

} // namespace gripscope
