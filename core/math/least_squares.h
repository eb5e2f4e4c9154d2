// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// Least squares by Householder's reflections (Golub and Van Loan, chapter 5), compiled once: each size of
/// matrix costs the compiler seconds wherever it is decomposed. Numbers must be finite and their squares must
/// not overflow.

/// min |A x - c| for each column c of the right-hand side, with column pivoting: the columns of A are ordered
/// by what the ones before leave of them.
struct PivotedSolution {
    Eigen::Index rank = 0;
    Eigen::MatrixXd solution;  ///< columns of A x columns of c; 0 for columns beyond the rank
    Eigen::VectorXd explained; ///< |part of c within the span of A|^2, for each c
    Eigen::VectorXd rest;      ///< |part of c outside|^2, for each c: the residual sum of squares
};

/// What a column must have left to count in the rank.
struct RankThreshold {
    double relative = 0; ///< to the largest column; 0: rounding times the number of columns
    double absolute = 0;
};

[[nodiscard]] PivotedSolution solvePivoted(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right,
                                           RankThreshold threshold = {});

/// A = Q R with at least as many rows as columns, the columns in their order; the signs of R's rows mean
/// nothing.
struct Triangularized {
    Eigen::MatrixXd triangle; ///< R, upper triangular, columns x columns
    Eigen::MatrixXd right;    ///< the rows of Q'c that belong to R
};

[[nodiscard]] Triangularized triangularize(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// R of the same alone.
[[nodiscard]] Eigen::MatrixXd triangleOf(const Eigen::MatrixXd& matrix);

/// The first columns of Q: an orthonormal basis of the span of A, whose columns must be independent.
[[nodiscard]] Eigen::MatrixXd orthonormalColumns(const Eigen::MatrixXd& matrix);

/// R^-1 of an upper triangular matrix (whatever stands below its diagonal).
[[nodiscard]] Eigen::MatrixXd inverseOfTriangle(const Eigen::MatrixXd& triangle);

/// min |R d - c|^2 + damping |D d|^2 by QR with column pivoting, D the diagonal of `scales`.
[[nodiscard]] Eigen::VectorXd dampedLeastSquares(const Eigen::MatrixXd& triangle,
                                                 const Eigen::VectorXd& right, const Eigen::VectorXd& scales,
                                                 double damping);

} // namespace gripscope
