// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/library_witness.h"
#include "core/library/spill/spill_file.h"
#include "core/library/spill/spilled_inspection.h"

#include <optional>
#include <vector>

namespace gripscope {

/// How a file names the library that it belongs to, whose first link that is.
[[nodiscard]] QByteArray spillOwner(const std::optional<ChainEnd>& birth);
/// A library without a row has no link yet, and gets its first one later.
[[nodiscard]] bool isSpillOwner(const QByteArray& named, const QByteArray& owner);
/// All of a file that can be read; it is `damaged` where that is not all there is.
[[nodiscard]] std::vector<SpilledInspection> unpackedOf(const SpillFile::Contents& contents, bool& damaged);

} // namespace gripscope
