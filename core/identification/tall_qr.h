// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// The triangle R of the QR decomposition of a matrix with few columns and any number of rows, which come one
/// by one: blocks of rows are folded into R by Householder reflections, so that a million rows need a few
/// kilobytes and nothing is squared (the condition number is that of the matrix, not of its normal
/// equations).
///
/// With the right-hand side as the last column, R holds the whole least-squares problem: solution, residual
/// norm (last diagonal element) and covariance. Rows must be scaled so that their squares do not overflow.
class TallQr {
public:
    explicit TallQr(Eigen::Index columns);

    /// Storage of the next row; fill all of it.
    [[nodiscard]] auto nextRow()
    {
        if (m_used == m_rows.rows())
            fold();
        return m_rows.row(m_used++);
    }
    /// columns x columns, upper triangular; the signs of its rows mean nothing.
    [[nodiscard]] Eigen::MatrixXd triangle();

private:
    void fold();

    Eigen::MatrixXd m_rows; ///< the triangle so far in the first rows, new rows below
    Eigen::Index m_used = 0;
};

/// Largest over smallest singular value after each column was scaled to norm 1; infinite when a column is
/// zero.
[[nodiscard]] double scaledConditionNumber(const Eigen::MatrixXd& matrix);

} // namespace gripscope
