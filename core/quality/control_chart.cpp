// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/distributions.h"
#include "core/quality/drift.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// A single squeeze further out than this says no more than that.
constexpr double leastChance = 1e-12;

double scoreOfStudent(double t, double degrees)
{
    const double chance = std::max(leastChance, studentAbove(std::abs(t), degrees));
    return std::copysign(normalQuantileAbove(chance), t);
}

/// |z| of a vector of three standard normals that is as improbable as a squared distance.
double radiusOf(double squaredDistance, double degrees)
{
    const double chance = std::max(leastChance, chanceBeyond(squaredDistance, degrees));
    return std::sqrt(chiSquaredQuantileAbove(chance, 3));
}

constexpr int states = 60;
constexpr double leastWeight = 0.01;
constexpr double shortestRunLength = 5, longestRunLength = 1e6;
constexpr int runLengthHalvings = 20;

/// P(|n|^2 <= x) for n ~ N(mean, I), |mean|^2 = `shift`.
double below(double x, double degrees, double shift)
{
    if (!(x > 0))
        return 0;
    if (shift < 1e-12)
        return chiSquaredBelow(x, degrees);
    return nonCentralChiSquaredBelow(x, degrees, shift);
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
    const TypePrediction expected = predictType(m_models, m_models.types[m_place], log,
                                                noise ? std::optional<LogMatrix>(*noise) : std::nullopt, {});
    if (!(expected.degreesOfFreedom >= 3))
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

std::optional<double> averageRunLength(double weight, int dimension, double limit)
{
    if (!(weight >= leastWeight && weight <= 1) || dimension < 1 || !(limit > 0) || !std::isfinite(limit))
        return {};
    // |e| from 0 to its limit in rings; the innermost is a disc of half the width.
    const double radius = std::sqrt(limit * weight / (2 - weight));
    const double width = radius / (states - 0.5);
    Eigen::MatrixXd remaining = Eigen::MatrixXd::Identity(states, states);
    for (int from = 0; from < states; ++from) {
        const double shift = std::pow((1 - weight) * from * width / weight, 2);
        double inner = 0;
        for (int to = 0; to < states; ++to) {
            const double outer = below(std::pow((to + 0.5) * width / weight, 2), dimension, shift);
            remaining(from, to) -= outer - inner;
            inner = outer;
        }
    }
    const Eigen::VectorXd lengths = remaining.partialPivLu().solve(Eigen::VectorXd::Ones(states));
    return std::isfinite(lengths(0)) && lengths(0) >= 1 ? std::optional(lengths(0)) : std::nullopt;
}

std::optional<double> movingAverageLimit(double weight, int dimension, double averageLength)
{
    if (!(averageLength >= shortestRunLength && averageLength <= longestRunLength))
        return {};
    double low = 0.01, high = 60.0 + 3 * std::max(1, dimension);
    for (int halving = 0; halving < runLengthHalvings; ++halving) {
        const double middle = (low + high) / 2;
        const std::optional<double> found = averageRunLength(weight, dimension, middle);
        if (!found && middle < 1)
            return {};
        (found && *found < averageLength ? low : high) = middle;
    }
    return high;
}

} // namespace gripscope
