// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/identification.h"
#include "core/signal/recording/recording.h"

#include <QString>

namespace gripscope::cli {

/// What `identify --csv` prints: a header, then a row a file and estimator (RFC 4180, decimal points, all
/// digits). m_95, b_95, k_95 are half the 95 % interval: `intervals` says whether of the uncertainty budget
/// (the recommended estimate, whose m, b and k are then without the empty gripper's) or of noise alone.
/// Numbers that do not exist are empty cells.
[[nodiscard]] QString identificationCsvHeader();
[[nodiscard]] QString identificationCsv(const Identification& identification, const Recording& recording,
                                        const QString& file);
/// The row of a file that could not be read.
[[nodiscard]] QString identificationCsv(const QString& file, const Error& error);

} // namespace gripscope::cli
