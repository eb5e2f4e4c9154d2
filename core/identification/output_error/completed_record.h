// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error_problem.h"

#include <vector>

namespace gripscope {

/// A record for estimators that take every force for known: at the lost samples the forces that output error
/// finds, and what it models for the positions, which are no measurement: their rows do not count.
struct CompletedRecord {
    Estimate outputError; ///< without parameters: nothing was completed, and it says why
    std::vector<double> force, position;
    std::vector<std::size_t> lost;
    /// By how much the largest standard error of m, b and k grows because the lost forces had to be found.
    double errorFactor = 1;
};

/// A record without losses comes back as it is, `outputError` empty with status Converged.
[[nodiscard]] CompletedRecord completedRecord(const std::vector<double>& force,
                                              const std::vector<double>& position,
                                              const ContinuousTimeOptions& options);

/// The problem of a completed record, for `options` that named what was lost.
[[nodiscard]] OutputErrorProblem completedProblem(const CompletedRecord& record,
                                                  const ContinuousTimeOptions& options);

} // namespace gripscope
