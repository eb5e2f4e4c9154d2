// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

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

/// A nuisance column of which less than this share is left beside the others does not count: it is rounding,
/// which makes such shares about 1e-15.
inline constexpr double dependentNuisance = 1e-12;

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

/// matrix = directions * diag(values) * directions', for a symmetric matrix (its lower triangle counts); the
/// smallest value first. Instantiated here once.
struct SymmetricAxes {
    Eigen::Vector3d values;
    Eigen::Matrix3d directions; ///< columns of length 1
};

[[nodiscard]] SymmetricAxes symmetricAxes(const Eigen::Matrix3d& matrix);

/// The same for up to 6 x 6, without memory of their own; of 3 x 3 the very same numbers.
struct SmallSymmetricAxes {
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1> values;
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6> directions;
};

[[nodiscard]] SmallSymmetricAxes smallSymmetricAxes(
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>& matrix);

/// Where a table lies and along which directions it spreads, the widest first.
struct PrincipalAxes {
    Eigen::RowVectorXd mean;
    Eigen::MatrixXd directions; ///< columns of length 1; the largest part of each is positive
    Eigen::VectorXd deviations; ///< population standard deviation along each
};

/// `items`: rows are items (at least one), finite, their squares too.
[[nodiscard]] PrincipalAxes principalAxes(const Eigen::MatrixXd& items);

/// exp(matrix) of a small square matrix by scaling and squaring (Higham 2005), to rounding error of its norm.
/// Instantiated here once. Numbers must be finite.
[[nodiscard]] Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& matrix);

} // namespace gripscope
