// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/identification/output_error.h"
#include "core/identification/periodic.h"
#include "core/signal/preparation.h"

namespace gripscope {

/// What every estimator is told.
struct EstimatorTask {
    ForceHold hold = ForceHold::First;
    bool freeInitialState = true;
    bool freeOffset = true;
    std::optional<std::size_t> period; ///< of the excitation, in samples, where it is known
};

/// One estimator on a prepared record. Output error takes lost samples as unknown forces; the others get the
/// longest stretch without any, said in Estimate::part, with a free initial state where that does not begin
/// the record. What `periodic` tells besides goes to `repetition`, its window in samples of the record.
[[nodiscard]] Estimate runEstimator(Estimator estimator, const PreparedRecord& record,
                                    const EstimatorTask& task,
                                    std::optional<PeriodicDiagnostics>* repetition = nullptr);

/// What output error is asked for by that.
[[nodiscard]] OutputErrorOptions outputErrorOptions(const PreparedRecord& record, const EstimatorTask& task);

/// The longest run of samples none of which is in `lost` (sorted); the first of equals.
[[nodiscard]] Window longestKnownStretch(std::size_t samples, const std::vector<std::size_t>& lost);

} // namespace gripscope
