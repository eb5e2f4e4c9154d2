// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/enrollment_draft.h"
#include "core/library/sql/statement.h"

namespace gripscope::draft_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const EnrollmentDraft& draft);
/// The newest row of this name once more, with that end; nothing when it is not open.
[[nodiscard]] Expected<void> end(Database& database, const RowStamp& stamp, const QString& name, DraftEnd end,
                                 const QString& operatorName);
/// Open ones, newest first; of this name only, unless it is empty.
[[nodiscard]] Expected<std::vector<EnrollmentDraft>> open(Database& database, const QString& name = {});

} // namespace gripscope::draft_table

namespace gripscope::draft_squeeze_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const DraftSqueeze& squeeze);
/// NotFound; StorageCorrupt when the bytes are not those that were stored.
[[nodiscard]] Expected<DraftSqueeze> read(Database& database, const QString& id);

} // namespace gripscope::draft_squeeze_table

namespace gripscope::picture_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const PartPicture& picture);
/// NotFound; StorageCorrupt when the bytes are not those that were stored.
[[nodiscard]] Expected<PartPicture> read(Database& database, const QString& id);

} // namespace gripscope::picture_table
