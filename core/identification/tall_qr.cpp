// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/tall_qr.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <limits>

namespace gripscope {

namespace {
/// Few enough to stay in the first-level cache, many enough that the triangle's own rows cost little.
constexpr Eigen::Index blockRows = 128;
} // namespace

TallQr::TallQr(Eigen::Index columns)
    : m_rows(Eigen::MatrixXd::Zero(columns + blockRows, columns)), m_used(columns)
{
}

void TallQr::fold()
{
    const Eigen::Index columns = m_rows.cols();
    Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(m_rows);
    m_rows.topRows(columns).triangularView<Eigen::StrictlyLower>().setZero();
    m_rows.bottomRows(m_rows.rows() - columns).setZero();
    m_used = columns;
}

Eigen::MatrixXd TallQr::triangle()
{
    fold();
    return m_rows.topRows(m_rows.cols());
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
