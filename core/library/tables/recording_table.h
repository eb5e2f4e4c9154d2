// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"
#include "core/signal/recording/recording.h"

namespace gripscope::recording_table {

/// Packed with zlib, with the SHA-256 of the unpacked bytes (packed_recording.h). Where the squeeze of a
/// draft has the same bytes, they stay there alone.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const Recording& recording, const QString& draftSqueezeId = {});
/// NotFound when the squeeze has none, StorageCorrupt when the bytes are not those that were stored.
[[nodiscard]] Expected<Recording> read(Database& database, const QString& graspId);

} // namespace gripscope::recording_table
