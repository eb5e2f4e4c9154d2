// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/small_regression.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <boost/math/distributions/fisher_f.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {
/// What is left of a column's norm when the columns before it are taken out must be more than this, or it
/// cannot be told from them.
constexpr double dependent = 1e-6;
} // namespace

SmallRegression::SmallRegression(const EffectTriangle& data, Eigen::Index nuisances, Eigen::Index known)
    : m_triangle(data.triangle), m_rows(data.rows), m_nuisances(nuisances), m_known(known)
{
    for (Eigen::Index i = 0; i < m_triangle.cols(); ++i) {
        const double norm = m_triangle.col(i).norm();
        m_norms.push_back(norm > 0 && std::isfinite(norm) ? norm : 1);
    }
}

SmallRegression::Answer SmallRegression::with(const std::vector<Eigen::Index>& extra) const
{
    const Eigen::Index model = m_nuisances + 3;
    const Eigen::Index own = model + static_cast<Eigen::Index>(extra.size());
    Eigen::MatrixXd columns(m_triangle.rows(), own + m_known);
    Eigen::VectorXd scale(columns.cols());
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
        Eigen::Index at = i;
        if (i >= own)
            at = m_triangle.cols() - 1 - m_known + i - own;
        else if (i >= model)
            at = model + extra[static_cast<std::size_t>(i - model)];
        scale(i) = 1 / m_norms[static_cast<std::size_t>(at)];
        columns.col(i) = m_triangle.col(at) * scale(i);
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
    qr.setThreshold(dependent);
    const Eigen::VectorXd right = m_triangle.col(m_triangle.cols() - 1);
    Answer answer;
    answer.rank = static_cast<double>(qr.rank());
    const Eigen::VectorXd rotated = qr.householderQ().adjoint() * right;
    answer.rest = rotated.tail(rotated.size() - qr.rank()).squaredNorm();
    answer.degreesOfFreedom = m_rows - answer.rank;
    answer.solution = scale.asDiagonal() * qr.solve(right);
    return answer;
}

Eigen::Vector3d SmallRegression::shiftBy(Eigen::Index effect) const
{
    return own().colPivHouseholderQr().solve(m_triangle.block<3, 1>(m_nuisances, m_nuisances + 3 + effect));
}

Eigen::Matrix3d SmallRegression::unitCovariance() const
{
    const Eigen::Matrix3d inverse = own().inverse();
    return inverse * inverse.transpose();
}

Eigen::Matrix3d SmallRegression::own() const
{
    return m_triangle.block<3, 3>(m_nuisances, m_nuisances);
}

FTest fTest(const SmallRegression::Answer& without, const SmallRegression::Answer& with)
{
    FTest test;
    test.columns = with.rank - without.rank;
    if (test.columns < 1 || with.degreesOfFreedom < 1 || !(with.rest > 0))
        return test;
    test.ratio =
        (std::max(without.rest - with.rest, 0.0) / test.columns) / (with.rest / with.degreesOfFreedom);
    if (!std::isfinite(test.ratio))
        return test;
    const boost::math::fisher_f distribution(test.columns, with.degreesOfFreedom);
    test.p = boost::math::cdf(boost::math::complement(distribution, test.ratio));
    return test;
}

} // namespace gripscope
