// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// exp(matrix) of a small square matrix by scaling and squaring (Higham 2005), to rounding error of its norm.
/// One place for it, since the templates behind it take long to build. Numbers must be finite.
[[nodiscard]] Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& matrix);

} // namespace gripscope
