// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace gripscope {

/// rows = against' part + factor * basis, for the rows that were kept: regressors as rows, a column a sample.
struct OrthonormalRows {
    Eigen::MatrixXd basis;   ///< orthonormal, a row for each kept regressor
    Eigen::MatrixXd factor;  ///< lower triangular, kept x kept
    Eigen::MatrixXd against; ///< kept x rows of the basis before: the coordinates there
    std::vector<Eigen::Index> kept;
};

/// Orthonormal basis of what `rows` add to the span of `against` (orthonormal rows, or empty), by Cholesky's
/// decomposition of their Gram matrix. A row of which less than a millionth is new is left out. For tests and
/// errors, which need a few digits; the estimates themselves come from decompositions that keep all.
[[nodiscard]] OrthonormalRows orthonormalize(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& against);

} // namespace gripscope
