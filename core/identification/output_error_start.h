// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error_model.h"

#include <limits>
#include <vector>

namespace gripscope {

/// Where the output-error search can begin, the candidate whose simulation fits best first.
struct OutputErrorStarts {
    std::vector<Eigen::Vector3d> bestFirst;
    bool trusted = false; ///< the first explains three quarters of the position's energy (a fit of 50 %)
};

/// Candidates from the data:
///  - least squares on state-variable filters of some bandwidths (Young 1981), m f_y'' + b f_y' + k f_y = f_u
///  with
///    f = signal / (1 + s/lambda)^2 and the filters' own free responses as extra columns, and
///  - the pole mapping of ARX(2,3,0), which is exact for a first-order hold.
/// The compliance of each is refitted, which is linear; those that then pull where the force pushes are
/// dropped.
[[nodiscard]] OutputErrorStarts outputErrorStarts(const OutputErrorProblem& problem);

/// Points that may be near the solution, the compliance of each refitted, which is linear; those that then
/// pull where the force pushes are dropped, and of the others the `most` that fit best are kept.
struct RankedCandidates {
    std::vector<Eigen::Vector3d> bestFirst;
    double leastCost = std::numeric_limits<double>::infinity(); ///< sum of squared residuals of the first
};
[[nodiscard]] RankedCandidates rankByResponse(const OutputErrorProblem& problem,
                                              const std::vector<Eigen::Vector3d>& candidates,
                                              std::size_t most);

/// Candidates for records that defeat those: the best points of a coarse grid over natural frequency (from a
/// twelfth of a swing a record to near half the sample rate) and damping, ranked on the first 2,000 samples.
/// Best first.
[[nodiscard]] std::vector<Eigen::Vector3d> outputErrorGrid(const OutputErrorProblem& problem);

} // namespace gripscope
