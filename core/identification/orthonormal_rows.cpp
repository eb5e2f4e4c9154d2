// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/orthonormal_rows.h"

#include <cmath>
#include <utility>

namespace gripscope {

namespace {
constexpr double newShare = 1e-6;
}

OrthonormalRows orthonormalize(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& against)
{
    const Eigen::Index count = rows.rows();
    Eigen::VectorXd norms = Eigen::VectorXd::Zero(count);
    for (Eigen::Index t = 0; t < rows.cols(); ++t)
        norms += rows.col(t).cwiseAbs2();
    norms = norms.cwiseSqrt().eval();
    const Eigen::VectorXd inverse = norms.unaryExpr(
        [](double n) { return n > 0 && std::isfinite(n) && std::isfinite(1 / n) ? 1 / n : 0.0; });
    Eigen::MatrixXd left = inverse.asDiagonal() * rows;
    Eigen::MatrixXd coordinates = Eigen::MatrixXd::Zero(count, against.rows());
    // Once leaves rounding errors of the part taken out, twice does not.
    for (int i = 0; i < 2 && against.rows() > 0; ++i) {
        const Eigen::MatrixXd part = left * against.transpose();
        left.noalias() -= part * against;
        coordinates += part;
    }
    const Eigen::MatrixXd gram = left * left.transpose();

    OrthonormalRows out;
    Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(count, count);
    Eigen::Index rank = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < rank; ++j) {
            const Eigen::Index column = out.kept[static_cast<std::size_t>(j)];
            lower(rank, j) =
                (gram(i, column) - lower.row(rank).head(j).dot(lower.row(j).head(j))) / lower(j, j);
        }
        const double rest = gram(i, i) - lower.row(rank).head(rank).squaredNorm();
        if (!(rest > newShare * newShare))
            continue;
        lower(rank, rank) = std::sqrt(rest);
        out.kept.push_back(i);
        ++rank;
    }
    const Eigen::MatrixXd triangle = lower.topLeftCorner(rank, rank);
    out.factor = triangle;
    out.against = Eigen::MatrixXd(rank, against.rows());
    if (rank < count) {
        for (Eigen::Index j = 0; j < rank; ++j)
            left.row(j) = left.row(out.kept[static_cast<std::size_t>(j)]).eval();
        left = left.topRows(rank).eval();
    }
    out.basis = std::move(left);
    for (Eigen::Index j = 0; j < rank; ++j) {
        const Eigen::Index i = out.kept[static_cast<std::size_t>(j)];
        out.factor.row(j) *= norms(i);
        out.against.row(j) = norms(i) * coordinates.row(i);
    }
    triangle.triangularView<Eigen::Lower>().solveInPlace(out.basis);
    return out;
}

} // namespace gripscope
