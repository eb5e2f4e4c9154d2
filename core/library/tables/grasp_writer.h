// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/squeeze_record.h"
#include "core/library/sql/database.h"

namespace gripscope {

// Inside a write transaction of the caller; errors as in Library.

/// Stores the squeeze with its recording, estimates and document; its key. `version`: of the library, for a
/// squeeze of a type.
[[nodiscard]] Expected<QString> storeGrasp(Database& database, const NewGrasp& grasp, qint64 version = 0);
[[nodiscard]] Expected<void> requireFinite(const Estimate& estimate);
[[nodiscard]] Expected<GraspRecord> requireGrasp(Database& database, const QString& id);

} // namespace gripscope
