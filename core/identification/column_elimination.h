// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// A matrix of at most 20 x 20 that needs no memory of its own.
inline constexpr int largestSmallMatrix = 20;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, largestSmallMatrix,
                                  largestSmallMatrix>;

/// What the first columns of a small least-squares problem (the triangle of a tall one) explain of the
/// others.
struct ColumnElimination {
    Eigen::Index rank = 0; ///< of the first columns
    SmallMatrix rest;      ///< (rows - rank) x others: the others with what the first explain taken out
    SmallMatrix taken;     ///< rank x others: what was taken out, in coordinates of its own
    SmallMatrix solution;  ///< first x others: the factors on the first columns that explain each other best
};

/// Householder reflections with column pivoting (Golub and Van Loan, section 5.4.2) on the first `count`
/// columns, each scaled to norm 1; a column of which less than `threshold` is left does not count, and its
/// factor is zero. Numbers must be finite and their squares must not overflow.
[[nodiscard]] ColumnElimination eliminateColumns(const SmallMatrix& matrix, Eigen::Index count,
                                                 double threshold);

/// The matrix with its first `count` columns made upper triangular, in their order, by the same reflections;
/// below the triangle stands zero.
[[nodiscard]] SmallMatrix eliminateOrdered(const SmallMatrix& matrix, Eigen::Index count);

} // namespace gripscope
