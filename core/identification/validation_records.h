// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/run_estimator.h"
#include "core/identification/validation.h"

namespace gripscope {

struct IdentificationOptions;

/// The estimator on the first 60 % of the record, held against the rest. Of a record longer than 100,000
/// samples its first 100,000. Says why where the record is too short for that or its first part gives no
/// estimate.
[[nodiscard]] Validation validateOnSecondWindow(Estimator estimator, const PreparedRecord& record,
                                                const EstimatorTask& task);

/// `estimate`, found from `recording`, against another squeeze, which is prepared first and brought to the
/// units of `recording`. Hold: that asked for, else the other recording's own, else first-order. Says why
/// where the units cannot be compared or the other recording cannot be used.
[[nodiscard]] Validation validateOnRecording(const Estimate& estimate, const Recording& recording,
                                             const Recording& other, const QString& name,
                                             const IdentificationOptions& options);

} // namespace gripscope
