// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// Where a table lies and along which directions it spreads, the widest first.
struct PrincipalAxes {
    Eigen::RowVectorXd mean;
    Eigen::MatrixXd directions; ///< columns of length 1; the largest part of each is positive
    Eigen::VectorXd deviations; ///< population standard deviation along each
};

/// `items`: rows are items (at least one), finite, their squares too.
[[nodiscard]] PrincipalAxes principalAxes(const Eigen::MatrixXd& items);

} // namespace gripscope
