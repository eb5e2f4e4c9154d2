// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/self_starting_chart.h"

#include "core/recognition/gates.h"
#include "core/recognition/predictive.h"
#include "core/recognition/quiet_policy.h"

#include <Eigen/Cholesky>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double dimensions = 3;
/// A single squeeze further out than this says no more than that.
constexpr double leastChance = 1e-12;

double scoreOfStudent(double t, double degrees)
{
    using boost::math::complement;
    const boost::math::students_t_distribution<double, QuietPolicy> student(degrees);
    const double chance = std::max(leastChance, boost::math::cdf(complement(student, std::abs(t))));
    const double score = boost::math::quantile(complement(boost::math::normal(), chance));
    return std::copysign(score, t);
}

/// |z| of a vector of three standard normals that is as improbable as a squared distance.
double radiusOf(double squaredDistance, double degrees)
{
    using boost::math::complement;
    const double chance = std::max(leastChance, chanceBeyond(squaredDistance, degrees));
    return std::sqrt(boost::math::quantile(complement(boost::math::chi_squared(dimensions), chance)));
}

} // namespace

SelfStartingChart::SelfStartingChart(const TypeModels& models, std::size_t place, double weight)
    : m_models(models), m_place(place), m_weight(weight), m_mean(models.types[place].meanLog),
      m_meanCovariance(models.types[place].meanCovarianceLog)
{
}

double SelfStartingChart::tSquared() const
{
    return m_joint.squaredNorm() * (2 - m_weight) / m_weight;
}

void SelfStartingChart::add(const Eigen::Vector3d& log, const std::optional<Eigen::Matrix3d>& noise)
{
    const TypePrediction expected = predictType(m_models, m_models.types[m_place], log, noise, {});
    if (!(expected.degreesOfFreedom >= dimensions))
        return;
    if (m_degrees == 0) {
        m_degrees = expected.degreesOfFreedom;
        m_sum = m_degrees * Eigen::Matrix3d::Identity();
    }
    const Eigen::Matrix3d innovation = expected.covariance + m_meanCovariance;
    const Eigen::LLT<Eigen::Matrix3d> cholesky(innovation);
    const Eigen::Vector3d residual = log - m_mean;
    const Eigen::Vector3d whitened = cholesky.matrixL().solve(residual);

    const Eigen::Matrix3d factor = cholesky.matrixL();
    const Eigen::Matrix3d seen = factor * m_sum * factor.transpose() / m_degrees;
    for (int i = 0; i < 3; ++i) {
        const double score = scoreOfStudent(residual(i) / std::sqrt(seen(i, i)), m_degrees);
        m_each(i) = m_weight * score + (1 - m_weight) * m_each(i);
    }
    const Eigen::LLT<Eigen::Matrix3d> spread(m_sum / m_degrees);
    const Eigen::Vector3d joint = spread.matrixL().solve(whitened);
    const double length = joint.norm();
    const double scale = length > 0 ? radiusOf(length * length, m_degrees) / length : 0;
    m_joint = m_weight * scale * joint + (1 - m_weight) * m_joint;

    const Eigen::Matrix3d gain = cholesky.solve(m_meanCovariance).transpose();
    m_mean += gain * residual;
    m_meanCovariance = (Eigen::Matrix3d::Identity() - gain) * m_meanCovariance;
    m_meanCovariance = ((m_meanCovariance + m_meanCovariance.transpose()) / 2).eval();
    m_sum += whitened * whitened.transpose();
    m_degrees += 1;
    m_squeezes += 1;
}

} // namespace gripscope
