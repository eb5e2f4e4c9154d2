// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/recognition/verdict/transfer.h"

namespace gripscope::cli {

/// The squeezes of one library, from another gripper, held against the types of `homeFile`; by the names of
/// the types. Errors: StorageOpen, UnitsDiffer.
[[nodiscard]] Expected<TransferReport> measuredTransfer(const QString& homeFile, const QString& otherFile);

} // namespace gripscope::cli
