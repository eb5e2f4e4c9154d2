// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/noise/residual_noise.h"

#include "core/identification/noise/noise_model.h"
#include "core/identification/noise/residual_tests.h"
#include "core/math/distributions.h"
#include "core/math/normal_interval.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscope {

namespace {

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

constexpr double certainColourP = 0.001;
/// Twice the gain in log-likelihood: 7.88 is the 99.5 % point of chi-square(1), whose half is the law here.
constexpr double certainForceNoise = 7.88;
/// Below these nobody needs to look further: one record in ten with white noise passes on to the likelihoods.
constexpr double suspiciousP = 0.05;
constexpr double suspiciousScore = 1.6;
constexpr std::size_t scoreLags = 20;

/// Autocorrelation of what white noise of the force does to the position.
std::vector<double> responseShape(const ForceResponse& g, std::size_t count)
{
    Eigen::VectorXd h(static_cast<Eigen::Index>(count));
    double last = 0;
    double beforeLast = 0;
    for (std::size_t t = 0; t < count; ++t) {
        const double next = (t < 3 ? g.b[t] : 0.0) - g.a[1] * last - g.a[2] * beforeLast;
        h(static_cast<Eigen::Index>(t)) = next;
        beforeLast = last;
        last = next;
    }
    std::vector<double> shape;
    for (std::size_t lag = 0; lag <= std::min(scoreLags, count / 5); ++lag) {
        const Eigen::Index rest = h.size() - static_cast<Eigen::Index>(lag);
        shape.push_back(h.head(rest).dot(h.tail(rest)));
    }
    for (std::size_t lag = shape.size(); lag-- > 0;)
        shape[lag] = shape[0] > 0 ? shape[lag] / shape[0] : 0;
    return shape;
}

bool isSuspicious(std::span<const double> residuals, const Eigen::MatrixXd& basis,
                  const ForceResponse& response, std::optional<double> whitenessP)
{
    if (whitenessP && *whitenessP < suspiciousP)
        return true;
    constexpr std::size_t memory = 2000;
    const std::vector<double> shape = responseShape(response, std::min(residuals.size(), memory));
    return noiseScore(residuals, basis, shape).value_or(0) > suspiciousScore;
}

} // namespace

std::optional<Eigen::MatrixXd> usableCovariance(const Eigen::MatrixXd& covariance)
{
    if (!covariance.allFinite() || !(covariance.diagonal().minCoeff() > 0))
        return std::nullopt;
    return Eigen::MatrixXd(0.5 * (covariance + covariance.transpose()));
}

double errorExpansion(double logVarianceSpread)
{
    double degrees = 2 / logVarianceSpread;
    if (std::isnan(degrees) || degrees < fewestDegreesOfFreedom)
        degrees = fewestDegreesOfFreedom;
    if (degrees >= 1e6)
        return 1;
    return studentQuantile(0.975, degrees) / normal95;
}

Eigen::VectorXd logVariances(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& gains,
                             const AutoregressiveNoise& noise)
{
    const Eigen::MatrixXd spread = gains * spreadUnderNoise(basis, noise) * gains.transpose();
    return spread.diagonal().array().log();
}

Eigen::VectorXd autoregressiveExpansion(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& gains,
                                        const AutoregressiveNoise& noise)
{
    const auto order = static_cast<Eigen::Index>(noise.coefficients.size());
    if (order == 0 || basis.cols() > longestCounted)
        return Eigen::VectorXd::Ones(gains.rows());
    const Eigen::MatrixXd slope = logSpreadSlopes(gains * basis, noise);
    const auto count = static_cast<double>(basis.cols());
    const Eigen::MatrixXd scatter = coefficientScatter(noise.coefficients);
    const Eigen::VectorXd spread = (slope * scatter * slope.transpose()).diagonal().array() + 2;
    return (spread / count).unaryExpr([](double value) { return errorExpansion(value); });
}

std::optional<ResidualNoise> findResidualNoise(std::span<const double> residuals,
                                               const Eigen::MatrixXd& basis, const Eigen::MatrixXd& gains,
                                               const ForceResponse& response,
                                               std::optional<double> whitenessP)
{
    if (!whitenessP || !isSuspicious(residuals, basis, response, whitenessP))
        return std::nullopt;
    const double logCount = std::log(static_cast<double>(residuals.size()));
    ResidualNoise found;
    Eigen::Vector3d expansion = Eigen::Vector3d::Ones();
    double best = 0;
    const bool coloured = *whitenessP < certainColourP;
    if (coloured) {
        const AutoregressiveNoise noise = fitAutoregressiveNoise(residuals, basis);
        const auto order = static_cast<double>(noise.coefficients.size());
        const double gain = 2 * restrictedGain(residuals, basis, noise) - order * logCount;
        if (order > 0 && gain > best) {
            best = gain;
            found.noise = noise;
            expansion = autoregressiveExpansion(basis, gains, noise);
            found.fittedNumbers = static_cast<int>(noise.coefficients.size());
        }
    }
    const std::optional<ForceNoiseFit> force = fitForceNoise(residuals, basis, gains, response);
    if (force && 2 * force->gain - logCount > best && (coloured || 2 * force->gain > certainForceNoise)) {
        best = 2 * force->gain - logCount;
        found.noise = force->noise;
        found.fittedNumbers = 1;
        expansion = force->expansion;
    }
    if (best <= 0)
        return std::nullopt;
    const Eigen::MatrixXd scaled = expansion.asDiagonal() * gains;
    const std::optional<Eigen::MatrixXd> covariance =
        usableCovariance(scaled * spreadUnderNoise(basis, found.noise) * scaled.transpose());
    if (!covariance)
        return std::nullopt;
    found.covariance = *covariance;
    return found;
}

} // namespace gripscope
