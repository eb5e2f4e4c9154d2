// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace gripscope {

/// The samples that, joined by straight lines, act as the natural cubic spline through `force` does: u - M /
/// 12, M the spline's second derivative a sample squared. Between two samples the spline bends away from the
/// chord by a parabola whose mean is -M / 12, so that the impulse over every step is kept; what the
/// parabola's shape does within the step is of the order T^4. A force that was sampled, not commanded, is
/// smooth: on straight lines its parts of angular frequency w come out too small by (w T)^2 / 12.
[[nodiscard]] std::vector<double> straightAsSpline(const std::vector<double>& force);

} // namespace gripscope
