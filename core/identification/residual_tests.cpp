// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/residual_tests.h"

#include "core/identification/fit.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gripscope {

namespace {

constexpr std::size_t largestLag = 20;
/// Forty residuals a lag: with fewer the tail of Q is heavier than the chi-square's (with ten, 0.5 %
/// becomes 1.1 %).
std::size_t ljungBoxLags(std::size_t residuals)
{
    return std::clamp<std::size_t>(residuals / 40, std::min<std::size_t>(3, residuals / 5), largestLag);
}
constexpr std::size_t inflationLags = 50;
/// Share of a column's norm below which what is left of it after the projection is rounding.
constexpr double dependent = 1e-8;

/// c_k = sum e[i] e[i - k] for k = 0..lags, of the residuals less their mean, in scaled units.
std::vector<double> autocovariances(std::span<const double> residuals, std::size_t lags)
{
    const double scale = powerOfTwoScale(residuals);
    std::vector<double> e(residuals.size());
    double mean = 0;
    for (std::size_t i = 0; i < e.size(); ++i) {
        e[i] = residuals[i] / scale;
        mean += e[i] / static_cast<double>(e.size());
    }
    for (double& value : e)
        value -= mean;
    std::vector<double> c(lags + 1, 0.0);
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        for (std::size_t i = lag; i < e.size(); ++i)
            c[lag] += e[i] * e[i - lag];
    }
    return c;
}

} // namespace

std::optional<double> ljungBoxP(std::span<const double> residuals, int fittedLags)
{
    const std::size_t lags = ljungBoxLags(residuals.size());
    const int degreesOfFreedom = static_cast<int>(lags) - fittedLags;
    if (degreesOfFreedom < 1)
        return std::nullopt;
    const std::vector<double> c = autocovariances(residuals, lags);
    if (!(c[0] > 0) || !std::isfinite(c[0]))
        return std::nullopt;
    const auto count = static_cast<double>(residuals.size());
    double q = 0;
    for (std::size_t lag = 1; lag <= lags; ++lag) {
        const double r = c[lag] / c[0];
        q += r * r / (count - static_cast<double>(lag));
    }
    q *= count * (count + 2);
    const boost::math::chi_squared distribution(degreesOfFreedom);
    return boost::math::cdf(boost::math::complement(distribution, q));
}

Eigen::RowVector<double, inputLags.size()> laggedInputs(std::span<const double> input, std::size_t t)
{
    Eigen::RowVector<double, inputLags.size()> row;
    for (std::size_t i = 0; i < inputLags.size(); ++i)
        row(static_cast<Eigen::Index>(i)) = input[t > inputLags[i] ? t - inputLags[i] : 0];
    return row;
}

std::optional<double> extraColumnsP(const Eigen::MatrixXd& triangle, Eigen::Index extraColumns, double rows)
{
    const Eigen::Index n = triangle.cols();
    const Eigen::Index model = n - 1 - extraColumns;
    // What the model leaves of the extra columns and of the right-hand side stands below its own rows.
    Eigen::MatrixXd left = triangle.block(model, model, n - model, extraColumns);
    const Eigen::VectorXd right = triangle.col(n - 1).tail(n - model);
    for (Eigen::Index i = 0; i < extraColumns; ++i) {
        const double norm = triangle.col(model + i).norm();
        left.col(i) /= norm > 0 ? norm : 1;
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(left);
    qr.setThreshold(dependent / std::max(qr.maxPivot(), dependent));
    const auto rank = static_cast<Eigen::Index>(qr.rank());
    const Eigen::VectorXd rotated = qr.householderQ().adjoint() * right;
    const double explained = rotated.head(rank).squaredNorm();
    const double rest = rotated.tail(rotated.size() - rank).squaredNorm();
    const double degreesOfFreedom = rows - static_cast<double>(model + rank);
    if (rank < 1 || degreesOfFreedom < 1 || !(rest > 0) || !std::isfinite(explained / rest))
        return std::nullopt;
    const double f = (explained / static_cast<double>(rank)) / (rest / degreesOfFreedom);
    const boost::math::fisher_f distribution(static_cast<double>(rank), degreesOfFreedom);
    return boost::math::cdf(boost::math::complement(distribution, f));
}

std::optional<double> errorInflation(const Eigen::MatrixXd& sensitivities, std::span<const double> residuals)
{
    const Eigen::Index rows = sensitivities.rows();
    const std::size_t lags = std::min(inflationLags, residuals.size() / 10);
    if (lags < 1 || rows != static_cast<Eigen::Index>(residuals.size()))
        return std::nullopt;
    const std::vector<double> c = autocovariances(residuals, lags);
    if (!(c[0] > 0))
        return std::nullopt;
    const Eigen::MatrixXd information = sensitivities.transpose() * sensitivities;
    Eigen::MatrixXd spread = information;
    for (std::size_t lag = 1; lag <= lags; ++lag) {
        const auto shift = static_cast<Eigen::Index>(lag);
        const double taper = 1 - static_cast<double>(lag) / static_cast<double>(lags + 1);
        const Eigen::MatrixXd product =
            sensitivities.bottomRows(rows - shift).transpose() * sensitivities.topRows(rows - shift);
        spread += taper * c[lag] / c[0] * (product + product.transpose());
    }
    const Eigen::MatrixXd inverse = information.inverse();
    const Eigen::VectorXd ratio =
        (inverse * spread * inverse).diagonal().cwiseQuotient(inverse.diagonal()).cwiseMax(0.0).cwiseSqrt();
    const double worst = ratio.maxCoeff();
    return std::isfinite(worst) ? std::optional(worst) : std::nullopt;
}

} // namespace gripscope
