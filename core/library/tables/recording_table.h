// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"
#include "core/signal/recording/recording.h"

namespace gripscope::recording_table {

/// Packed with zlib, with the SHA-256 of the unpacked bytes (packed_recording.h).
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const Recording& recording);
/// NotFound when the squeeze has none, StorageCorrupt when the bytes are not those that were stored.
[[nodiscard]] Expected<Recording> read(Database& database, const QString& graspId);

} // namespace gripscope::recording_table
