// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/error_expansion.h"

#include "core/identification/noise_model.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double quantile975 = 1.959963984540054; // standard normal, 97.5 %
constexpr double fewestDegreesOfFreedom = 3;
constexpr Eigen::Index longestCounted = 20000;

/// N times the covariance of the coefficients: the innovations' variance times the inverse of the Toeplitz
/// matrix of autocovariances, from the coefficients alone (Gohberg and Semencul 1972).
Eigen::MatrixXd coefficientScatter(const std::vector<double>& coefficients)
{
    const auto order = static_cast<Eigen::Index>(coefficients.size());
    Eigen::MatrixXd forward = Eigen::MatrixXd::Identity(order, order);
    Eigen::MatrixXd backward = Eigen::MatrixXd::Zero(order, order);
    for (Eigen::Index i = 0; i < order; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) {
            if (i > j)
                forward(i, j) = -coefficients[static_cast<std::size_t>(i - j - 1)];
            backward(i, j) = -coefficients[static_cast<std::size_t>(order - 1 - (i - j))];
        }
    }
    return forward * forward.transpose() - backward * backward.transpose();
}

} // namespace

double errorExpansion(double logVarianceSpread)
{
    double degrees = 2 / logVarianceSpread;
    if (std::isnan(degrees) || degrees < fewestDegreesOfFreedom)
        degrees = fewestDegreesOfFreedom;
    if (degrees >= 1e6)
        return 1;
    return boost::math::quantile(boost::math::students_t(degrees), 0.975) / quantile975;
}

Eigen::Vector3d logVariances(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& gains,
                             const AutoregressiveNoise& noise)
{
    const Eigen::MatrixXd spread = gains * spreadUnderNoise(basis, noise) * gains.transpose();
    return spread.diagonal().array().log();
}

Eigen::Vector3d autoregressiveExpansion(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& gains,
                                        const AutoregressiveNoise& noise)
{
    const auto order = static_cast<Eigen::Index>(noise.coefficients.size());
    if (order == 0 || basis.cols() > longestCounted)
        return Eigen::Vector3d::Ones();
    constexpr double step = 1e-4;
    Eigen::Matrix3Xd slope(3, order);
    for (Eigen::Index i = 0; i < order; ++i) {
        AutoregressiveNoise below = noise;
        AutoregressiveNoise above = noise;
        below.coefficients[static_cast<std::size_t>(i)] -= step;
        above.coefficients[static_cast<std::size_t>(i)] += step;
        slope.col(i) = (logVariances(basis, gains, above) - logVariances(basis, gains, below)) / (2 * step);
    }
    const auto count = static_cast<double>(basis.cols());
    const Eigen::MatrixXd scatter = coefficientScatter(noise.coefficients);
    const Eigen::Vector3d spread = (slope * scatter * slope.transpose()).diagonal().array() + 2;
    return (spread / count).unaryExpr([](double value) { return errorExpansion(value); });
}

} // namespace gripscope
