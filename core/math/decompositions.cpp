// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/decompositions.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// The reflection that clears a column below the diagonal, on it and all columns after it.
void reflect(SmallMatrix& work, Eigen::Index step)
{
    const Eigen::Index below = work.rows() - step - 1;
    const double square = work.col(step).tail(below).squaredNorm();
    if (square == 0)
        return;
    const double first = work(step, step);
    const double norm = std::sqrt(first * first + square);
    const double corner = first + std::copysign(norm, first);
    const double scale = 1 / (norm * std::abs(corner));
    for (Eigen::Index j = step + 1; j < work.cols(); ++j) {
        const double share =
            scale * (corner * work(step, j) + work.col(step).tail(below).dot(work.col(j).tail(below)));
        work(step, j) -= share * corner;
        work.col(j).tail(below) -= share * work.col(step).tail(below);
    }
    work(step, step) = -std::copysign(norm, first);
    work.col(step).tail(below).setZero();
}

class Elimination {
public:
    Elimination(const SmallMatrix& matrix, Eigen::Index count) : m_work(matrix), m_count(count)
    {
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const double norm = m_work.col(i).norm();
            m_scale[at] = norm > 0 ? 1 / norm : 0;
            m_work.col(i) *= m_scale[at];
            m_original[at] = i;
        }
    }

    ColumnElimination run(double threshold)
    {
        const Eigen::Index most = std::min(m_count, m_work.rows());
        Eigen::Index rank = 0;
        while (rank < most && pivot(rank) > threshold) {
            reflect(m_work, rank);
            ++rank;
        }
        const Eigen::Index others = m_work.cols() - m_count;
        ColumnElimination out;
        out.rank = rank;
        out.rest = m_work.bottomRightCorner(m_work.rows() - rank, others);
        out.taken = m_work.topRightCorner(rank, others);
        out.solution = SmallMatrix::Zero(m_count, others);
        for (Eigen::Index j = 0; j < others; ++j)
            solve(rank, j, out);
        return out;
    }

private:
    /// Brings the column with most left to place `step`; its norm.
    double pivot(Eigen::Index step)
    {
        Eigen::Index best = step;
        double largest = -1;
        for (Eigen::Index i = step; i < m_count; ++i) {
            const double left = m_work.col(i).tail(m_work.rows() - step).squaredNorm();
            if (left > largest) {
                largest = left;
                best = i;
            }
        }
        m_work.col(step).swap(m_work.col(best));
        std::swap(m_original[static_cast<std::size_t>(step)], m_original[static_cast<std::size_t>(best)]);
        return std::sqrt(largest);
    }

    void solve(Eigen::Index rank, Eigen::Index other, ColumnElimination& out) const
    {
        std::array<double, largestSmallMatrix> factors{};
        for (Eigen::Index i = rank - 1; i >= 0; --i) {
            double value = m_work(i, m_count + other);
            for (Eigen::Index j = i + 1; j < rank; ++j)
                value -= m_work(i, j) * factors[static_cast<std::size_t>(j)];
            value /= m_work(i, i);
            factors[static_cast<std::size_t>(i)] = value;
            const Eigen::Index column = m_original[static_cast<std::size_t>(i)];
            out.solution(column, other) = value * m_scale[static_cast<std::size_t>(column)];
        }
    }

    SmallMatrix m_work;
    Eigen::Index m_count;
    std::array<double, largestSmallMatrix> m_scale{};
    std::array<Eigen::Index, largestSmallMatrix> m_original{};
};

constexpr double newShare = 1e-6;

} // namespace

ColumnElimination eliminateColumns(const SmallMatrix& matrix, Eigen::Index count, double threshold)
{
    return Elimination(matrix, count).run(threshold);
}

SmallMatrix eliminateOrdered(const SmallMatrix& matrix, Eigen::Index count)
{
    SmallMatrix work = matrix;
    for (Eigen::Index step = 0; step < std::min(count, work.rows()); ++step)
        reflect(work, step);
    return work;
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

SymmetricAxes symmetricAxes(const Eigen::Matrix3d& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

SmallSymmetricAxes
smallSymmetricAxes(const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>& matrix)
{
    if (matrix.rows() == 3) {
        const SymmetricAxes axes = symmetricAxes(matrix);
        return {axes.values, axes.directions};
    }
    using Matrix = std::decay_t<decltype(matrix)>;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

PrincipalAxes principalAxes(const Eigen::MatrixXd& items)
{
    PrincipalAxes axes;
    axes.mean = items.colwise().mean();
    const Eigen::MatrixXd away = items.rowwise() - axes.mean;
    const Eigen::MatrixXd covariance = away.transpose() * away / double(items.rows());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    axes.directions = solver.eigenvectors().rowwise().reverse();
    axes.deviations = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
    for (Eigen::Index j = 0; j < axes.directions.cols(); ++j) {
        Eigen::Index largest = 0;
        axes.directions.col(j).cwiseAbs().maxCoeff(&largest);
        if (axes.directions(largest, j) < 0)
            axes.directions.col(j) *= -1;
    }
    return axes;
}

} // namespace gripscope
