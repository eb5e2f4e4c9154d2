// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <functional>

namespace gripscope {

/// Told how much is done, from 0 to 1; says whether to go on.
using CopyProgress = std::function<bool(double share)>;

/// All of the database in `from`, as it stands at one moment, in the new file `to`: also while others write,
/// who need not wait. What it holds is on the disk when this returns, and nothing lies beside it. Cancelled
/// or failed, there is no such file. FileUnwritable: there is one already.
[[nodiscard]] Expected<void> copyDatabase(const QString& from, const QString& to,
                                          const CopyProgress& progress);

/// Nobody else has the file open: all that was written is in it afterwards, and nothing lies beside it.
/// StorageFailed where another connection has it open.
[[nodiscard]] Expected<void> foldIntoOneFile(const QString& file);

} // namespace gripscope
