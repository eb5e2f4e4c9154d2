// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace gripscope {

/// The triangle R of the QR decomposition of a matrix with few columns and any number of rows, which come one
/// by one: blocks of rows are folded into R by Householder reflections, so that a million rows need a few
/// kilobytes and nothing is squared (the condition number is that of the matrix, not of its normal
/// equations). 2 columns^2 operations a row; columns of which a block holds only zeros cost nothing.
///
/// With the right-hand side as the last column, R holds the whole least-squares problem: solution, residual
/// norm (last diagonal element) and covariance. Rows must be scaled so that their squares do not overflow.
class SequentialQr {
public:
    /// Few enough to stay in the first-level cache, many enough that the triangle's own rows cost little.
    static constexpr Eigen::Index blockRows = 64;

    explicit SequentialQr(Eigen::Index columns);

    /// Storage of the next row; fill all of it.
    [[nodiscard]] auto nextRow()
    {
        if (m_used == blockRows)
            fold();
        return m_block.row(m_used++);
    }
    /// Storage of the next rows, at most `atMost` of them; fill all of them.
    [[nodiscard]] auto nextRows(Eigen::Index atMost)
    {
        if (m_used == blockRows)
            fold();
        const Eigen::Index first = m_used;
        m_used = std::min(blockRows, first + atMost);
        return m_block.middleRows(first, m_used - first);
    }
    /// columns x columns, upper triangular; the signs of its rows mean nothing. Folds the rows so far.
    [[nodiscard]] const Eigen::MatrixXd& triangle();
    /// The same for a change of the columns' meaning between two rows; must be left upper triangular.
    [[nodiscard]] Eigen::MatrixXd& changeTriangle();
    /// Folds only the first `columns` of the one row that is there, and returns what the rows before leave of
    /// its other columns: recursive residuals (Brown, Durbin and Evans 1975), which are uncorrelated and of
    /// variance s^2 when the rows' errors are, and nothing when the row was needed to determine a column.
    /// Valid until the next row.
    [[nodiscard]] auto takeOut(Eigen::Index columns)
    {
        for (Eigen::Index column = 0; column < columns; ++column)
            reflect(column);
        m_used = 0;
        return m_block.row(0).tail(m_block.cols() - columns).transpose();
    }
    void clear();

private:
    void fold();
    void reflect(Eigen::Index column);

    using Block = Eigen::Matrix<double, blockRows, Eigen::Dynamic>;
    Block m_block;
    Eigen::MatrixXd m_triangle;
    Eigen::Index m_used = 0;
};

/// Largest over smallest singular value after each column was scaled to norm 1; infinite when a column is
/// zero.
[[nodiscard]] double scaledConditionNumber(const Eigen::MatrixXd& matrix);

} // namespace gripscope
