// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validation/validation_contrast.h"

#include "core/identification/noise/noise_model.h"
#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

ValidationContrast::ValidationContrast(const GivenModel& model, const AutoregressiveNoise& noise,
                                       const Eigen::MatrixXd& estimateCovariance)
    : m_nuisances(orthonormalize(whitened(model.nuisances, noise), {})),
      m_parameters(orthonormalize(whitened(model.parameters, noise), m_nuisances.basis)),
      m_estimateCovariance(estimateCovariance)
{
    Eigen::RowVectorXd residual = whitened(Eigen::MatrixXd(model.residual), noise);
    residual -= (residual * m_nuisances.basis.transpose()) * m_nuisances.basis;
    m_coordinates = m_parameters.basis * residual.transpose();
    m_rest = residual - m_coordinates.transpose() * m_parameters.basis;
    m_degreesOfFreedom = static_cast<double>(residual.size() - m_nuisances.basis.rows() - rank());
    m_variance = m_degreesOfFreedom > 0 ? m_rest.squaredNorm() / m_degreesOfFreedom : 0;
    const Eigen::MatrixXd along = whitened(model.parameters, noise) * m_parameters.basis.transpose();
    m_fromEstimate = along.transpose() * estimateCovariance * along;
    m_root.compute(m_fromEstimate + m_variance * Eigen::MatrixXd::Identity(rank(), rank()));
}

bool ValidationContrast::usable() const
{
    return m_degreesOfFreedom > 0 && m_variance > 0 && rank() > 0 && m_fromEstimate.allFinite() &&
           m_root.info() == Eigen::Success;
}

ExplainedTest ValidationContrast::test(double estimateFreedom) const
{
    const auto p = static_cast<double>(rank());
    const Eigen::VectorXd weighted = m_root.solve(m_coordinates);
    const double squared = m_coordinates.dot(weighted);
    const double ofEstimate = weighted.dot(m_fromEstimate * weighted) / squared;
    const double ofNoise = 1 - ofEstimate;
    const double pooled = 1 / (ofEstimate * ofEstimate / std::max(estimateFreedom, 1.0) +
                               ofNoise * ofNoise / m_degreesOfFreedom);
    const double freedom = std::max(pooled - p + 1, 1.0);
    ExplainedTest out;
    const double f = squared * freedom / (std::max(pooled, p) * p);
    if (!(f > 0) || !std::isfinite(f))
        return out;
    out.f = f;
    out.p = fisherAbove(f, p, freedom);
    return out;
}

Eigen::RowVectorXd ValidationContrast::standardized() const
{
    const Eigen::VectorXd scaled = std::sqrt(m_variance) * m_root.matrixL().solve(m_coordinates);
    return m_rest + scaled.transpose() * m_parameters.basis;
}

std::optional<ValidationContrast::Change> ValidationContrast::change() const
{
    if (rank() != m_estimateCovariance.rows())
        return std::nullopt;
    const Eigen::MatrixXd triangle = m_parameters.factor.transpose();
    const Eigen::MatrixXd inverse =
        triangle.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(rank(), rank()));
    const Eigen::MatrixXd covariance = m_estimateCovariance + m_variance * (inverse * inverse.transpose());
    Change out{inverse * m_coordinates, covariance.diagonal().cwiseMax(0).cwiseSqrt()};
    if (!out.step.allFinite() || !out.errors.allFinite())
        return std::nullopt;
    return out;
}

} // namespace gripscope
