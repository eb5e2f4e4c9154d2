// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/sequential_qr.h"

#include <Eigen/SVD>

#include <cmath>
#include <limits>

namespace gripscope {

SequentialQr::SequentialQr(Eigen::Index columns)
    : m_block(Block::Zero(blockRows, columns)), m_triangle(Eigen::MatrixXd::Zero(columns, columns))
{
}

void SequentialQr::clear()
{
    m_triangle.setZero();
    m_used = 0;
}

/// The reflection that folds the block's part of a column into the triangle's diagonal, on all columns after
/// it. Its vector is (corner, block part), everything between them being zero.
void SequentialQr::reflect(Eigen::Index column)
{
    const auto part = m_block.col(column).head(m_used);
    const double square = part.squaredNorm();
    if (square == 0)
        return;
    double& diagonal = m_triangle(column, column);
    const double norm = std::sqrt(square + diagonal * diagonal);
    const double corner = diagonal + std::copysign(norm, diagonal);
    const double scale = 1 / (norm * std::abs(corner));
    diagonal = -std::copysign(norm, diagonal);
    for (Eigen::Index j = column + 1; j < m_triangle.cols(); ++j) {
        auto other = m_block.col(j).head(m_used);
        const double share = scale * (corner * m_triangle(column, j) + part.dot(other));
        m_triangle(column, j) -= share * corner;
        other -= share * part;
    }
}

void SequentialQr::fold()
{
    for (Eigen::Index column = 0; column < m_triangle.cols(); ++column)
        reflect(column);
    m_used = 0;
}

const Eigen::MatrixXd& SequentialQr::triangle()
{
    fold();
    return m_triangle;
}

Eigen::MatrixXd& SequentialQr::changeTriangle()
{
    fold();
    return m_triangle;
}

double scaledConditionNumber(const Eigen::MatrixXd& matrix)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Eigen::MatrixXd scaled = matrix;
    for (Eigen::Index i = 0; i < scaled.cols(); ++i) {
        const double norm = scaled.col(i).norm();
        if (!(norm > 0) || !std::isfinite(norm))
            return infinite;
        scaled.col(i) /= norm;
    }
    const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(scaled).singularValues();
    const double smallest = singular(singular.size() - 1);
    return smallest > 0 ? singular(0) / smallest : infinite;
}

} // namespace gripscope
