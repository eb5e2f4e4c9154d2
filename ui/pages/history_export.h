// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/history_document.h"
#include "ui/stepped_work.h"

namespace gripscope {

/// Steps that write all that a query finds to `file`, whole or not at all.
[[nodiscard]] SteppedWork::Step historyExport(const HistoryQuery& query, HistoryFormat format,
                                              const QString& file);
/// Steps that write the recordings of these squeezes as CSV files into `folder`; those that have none are
/// left out. A file that is there already is replaced.
[[nodiscard]] SteppedWork::Step recordingExport(std::vector<QString> graspIds, const QString& folder);
/// "inspection_000412.csv", "enrolment_Can_G1B2.csv": the end of the key tells squeezes of a type apart.
[[nodiscard]] QString recordingFileName(const HistoryEntry& entry);

} // namespace gripscope
