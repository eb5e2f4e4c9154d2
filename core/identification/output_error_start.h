// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error_model.h"

#include <optional>

namespace gripscope {

/// A force whose response differs this little from what a free start and offset can imitate says nothing.
inline constexpr double smallestOwnShare = 1e-9;

/// Where the output-error search begins: the candidate whose simulation fits best, out of
///  - least squares on state-variable filters of some bandwidths (Young 1981), m f_y'' + b f_y' + k f_y = f_u
///  with
///    f = signal / (1 + s/lambda)^2 and the filters' own free responses as extra columns,
///  - the pole mapping of ARX(2,3,0), which is exact for a first-order hold, and
///  - when none of them explains the record, a coarse grid over natural frequency and damping.
/// The compliance of each candidate is refitted, which is linear. Nothing: no candidate moves the position.
[[nodiscard]] std::optional<Eigen::Vector3d> outputErrorStart(const OutputErrorProblem& problem);

} // namespace gripscope
