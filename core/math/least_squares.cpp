// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/least_squares.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

using Pivoted = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
using Ordered = Eigen::HouseholderQR<Eigen::MatrixXd>;

} // namespace

PivotedSolution solvePivoted(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right,
                             RankThreshold threshold)
{
    Pivoted qr(matrix);
    if (threshold.relative > 0)
        qr.setThreshold(threshold.relative);
    if (threshold.absolute > 0)
        qr.setThreshold(threshold.absolute / std::max(qr.maxPivot(), threshold.absolute));
    PivotedSolution out;
    out.rank = qr.rank();
    Eigen::MatrixXd rotated = right;
    rotated.applyOnTheLeft(qr.householderQ().adjoint());
    out.explained = rotated.topRows(out.rank).colwise().squaredNorm().transpose();
    out.rest = rotated.bottomRows(rotated.rows() - out.rank).colwise().squaredNorm().transpose();
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(matrix.cols(), right.cols());
    factors.topRows(out.rank) = rotated.topRows(out.rank);
    for (Eigen::Index i = out.rank - 1; i >= 0; --i) {
        factors.row(i) /= qr.matrixQR()(i, i);
        for (Eigen::Index above = 0; above < i; ++above)
            factors.row(above) -= qr.matrixQR()(above, i) * factors.row(i);
    }
    out.solution = qr.colsPermutation() * factors;
    return out;
}

Triangularized triangularize(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right)
{
    const Ordered qr(matrix);
    Eigen::MatrixXd rotated = right;
    rotated.applyOnTheLeft(qr.householderQ().adjoint());
    return {qr.matrixQR().topRows(matrix.cols()).triangularView<Eigen::Upper>(),
            rotated.topRows(matrix.cols())};
}

Eigen::MatrixXd triangleOf(const Eigen::MatrixXd& matrix)
{
    return Ordered(matrix).matrixQR().topRows(matrix.cols()).triangularView<Eigen::Upper>();
}

Eigen::MatrixXd orthonormalColumns(const Eigen::MatrixXd& matrix)
{
    Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
    basis.applyOnTheLeft(Ordered(matrix).householderQ());
    return basis;
}

Eigen::MatrixXd inverseOfTriangle(const Eigen::MatrixXd& triangle)
{
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(triangle.cols(), triangle.cols());
    triangle.topRows(triangle.cols()).triangularView<Eigen::Upper>().solveInPlace(inverse);
    return inverse;
}

Eigen::VectorXd dampedLeastSquares(const Eigen::MatrixXd& triangle, const Eigen::VectorXd& right,
                                   const Eigen::VectorXd& scales, double damping)
{
    const Eigen::Index n = scales.size();
    Eigen::MatrixXd stacked(2 * n, n);
    stacked.topRows(n) = triangle;
    stacked.bottomRows(n) = (std::sqrt(damping) * scales).asDiagonal();
    Eigen::VectorXd extended = Eigen::VectorXd::Zero(2 * n);
    extended.head(n) = right;
    // Columns of very different size: scale, so that the rank decision of the pivoting means something.
    const Eigen::VectorXd norms = stacked.colwise().norm().transpose().cwiseMax(1e-300);
    stacked *= norms.cwiseInverse().asDiagonal();
    return norms.cwiseInverse().asDiagonal() * solvePivoted(stacked, extended).solution.col(0);
}

} // namespace gripscope
