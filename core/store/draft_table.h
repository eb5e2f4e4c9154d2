// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/enrollment_draft.h"
#include "core/store/statement.h"

namespace gripscope::draft_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const EnrollmentDraft& draft);
/// The newest row of this name once more, with that end; nothing when it is not open.
[[nodiscard]] Expected<void> end(Database& database, const RowStamp& stamp, const QString& name, DraftEnd end,
                                 const QString& operatorName);
/// Open ones, newest first; of this name only, unless it is empty.
[[nodiscard]] Expected<std::vector<EnrollmentDraft>> open(Database& database, const QString& name = {});

} // namespace gripscope::draft_table
