// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/motion/motion.h"
#include "core/identification/output_error/output_error.h"
#include "core/identification/periodic/periodic.h"
#include "core/signal/preparation/preparation.h"

namespace gripscope {

/// What every estimator is told.
struct EstimatorTask {
    ForceHold hold = ForceHold::First;
    bool freeInitialState = true;
    bool freeOffset = true;
    std::optional<std::size_t> period;              ///< of the excitation, in samples, where it is known
    ResidualDepth residuals = ResidualDepth::Tests; ///< of output error
    const Estimate* near = nullptr; ///< what a motion with further terms is expected to be close to
};

/// Options of any estimator of m, b, k in continuous time: they name the same things alike.
template <typename Options>
[[nodiscard]] Options continuousOptions(const PreparedRecord& record, const EstimatorTask& task)
{
    Options options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = task.hold;
    options.lag_s = record.forceLag_s;
    options.freeInitialState = task.freeInitialState;
    options.freeOffset = task.freeOffset;
    return options;
}

/// One estimator on a prepared record. Output error, instrumental variables and motions with further terms
/// take lost samples as unknown forces; the others get the longest stretch without any, said in
/// Estimate::part, with a free initial state where that does not begin the record. What `periodic` tells
/// besides goes to `repetition`, its window in samples of the record. Where the position is held `static`
/// bounds the stiffness (quasistatic/held_stiffness.h), and no other estimator applies.
[[nodiscard]] Estimate runEstimator(Estimator estimator, const PreparedRecord& record,
                                    const EstimatorTask& task,
                                    std::optional<PeriodicDiagnostics>* repetition = nullptr);

/// What output error is asked for by that.
[[nodiscard]] OutputErrorOptions outputErrorOptions(const PreparedRecord& record, const EstimatorTask& task);

/// What an estimator of the family of MotionTerms is asked for by that.
[[nodiscard]] MotionOptions motionOptions(Estimator estimator, const PreparedRecord& record,
                                          const EstimatorTask& task);

/// The longest run of samples none of which is in `lost` (sorted); the first of equals.
[[nodiscard]] Window longestKnownStretch(std::size_t samples, const std::vector<std::size_t>& lost);

} // namespace gripscope
