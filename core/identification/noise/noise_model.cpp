// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/noise/noise_model.h"

#include "core/math/fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gripscope {

namespace {

constexpr std::size_t largestNoiseOrder = 20;
constexpr int corrections = 3;
/// With more residuals than this the part that the parameters take out is below 0.1 %.
constexpr std::size_t largestCorrected = 20000;
/// What is left of a response when it has died away.
constexpr double diedAway = 1e-7;
constexpr Eigen::Index longestMemory = 20000;

struct NoiseCandidate {
    std::vector<double> coefficients;
    double variance = 0;
};

/// Levinson's recursion: the models of order 0, 1, ... as far as the autocovariances are positive definite.
std::vector<NoiseCandidate> levinson(const std::vector<double>& c)
{
    std::vector<NoiseCandidate> models{{{}, c[0]}};
    for (std::size_t order = 1; order < c.size(); ++order) {
        const NoiseCandidate& last = models.back();
        double numerator = c[order];
        for (std::size_t i = 0; i + 1 < order; ++i)
            numerator -= last.coefficients[i] * c[order - 1 - i];
        const double reflection = numerator / last.variance;
        if (!(std::abs(reflection) < 1))
            break;
        NoiseCandidate next;
        next.variance = last.variance * (1 - reflection * reflection);
        if (!(next.variance > 0))
            break;
        for (std::size_t i = 0; i + 1 < order; ++i)
            next.coefficients.push_back(last.coefficients[i] - reflection * last.coefficients[order - 2 - i]);
        next.coefficients.push_back(reflection);
        models.push_back(std::move(next));
    }
    return models;
}

NoiseCandidate bestByBic(const std::vector<double>& autocovariances, double count)
{
    const std::vector<NoiseCandidate> models = levinson(autocovariances);
    const auto criterion = [&](const NoiseCandidate& model) {
        return count * std::log(model.variance) +
               std::log(count) * static_cast<double>(model.coefficients.size());
    };
    return *std::min_element(
        models.begin(), models.end(),
        [&](const NoiseCandidate& a, const NoiseCandidate& b) { return criterion(a) < criterion(b); });
}

/// sum e[t] e[t - k] / N for k = 0..lags.
std::vector<double> autocovariances(const Eigen::VectorXd& e, std::size_t lags)
{
    std::vector<double> c;
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        const Eigen::Index rest = e.size() - static_cast<Eigen::Index>(lag);
        c.push_back(e.head(rest).dot(e.tail(rest)) / static_cast<double>(e.size()));
    }
    return c;
}

AutoregressiveNoise toNoise(const NoiseCandidate& model, double scale)
{
    AutoregressiveNoise noise;
    noise.coefficients = model.coefficients;
    noise.innovationDeviation = std::sqrt(model.variance) * scale;
    return noise;
}

/// z[s] = sum_t psi[t - s] x[t], psi the noise's answer to one innovation; a column a time, the earliest
/// last. Noise that is stationary has innovations before the record too.
Eigen::MatrixXd backward(const Eigen::MatrixXd& x, const AutoregressiveNoise& noise)
{
    const Eigen::Index count = x.cols();
    const bool fromRest = noise.forceDeviation.has_value();
    const auto order =
        static_cast<Eigen::Index>(std::max(noise.coefficients.size(), noise.movingAverage.size()));
    const Eigen::Index longest = fromRest || order == 0 ? count : count + std::min(count, longestMemory);
    Eigen::MatrixXd z(x.rows(), longest);
    double largest = 0;
    Eigen::Index small = 0;
    Eigen::Index at = 0;
    for (; at < longest; ++at) {
        if (at < count)
            z.col(at) = x.col(count - 1 - at);
        else
            z.col(at).setZero();
        const auto past = [&](std::size_t i) { return at - static_cast<Eigen::Index>(i) - 1; };
        for (std::size_t j = 0; j < noise.movingAverage.size() && past(j) >= 0; ++j) {
            if (past(j) < count)
                z.col(at) += noise.movingAverage[j] * x.col(count - 1 - past(j));
        }
        for (std::size_t i = 0; i < noise.coefficients.size() && past(i) >= 0; ++i)
            z.col(at) += noise.coefficients[i] * z.col(past(i));
        const double size = z.col(at).cwiseAbs().maxCoeff();
        largest = std::max(largest, size);
        small = size <= diedAway * largest ? small + 1 : 0;
        if (at >= count && small > order)
            break;
    }
    return z.leftCols(std::min(at, longest));
}

/// C x' for the rows of x, from z = backward(x), in units of the innovations' variance.
Eigen::MatrixXd forward(const Eigen::MatrixXd& z, Eigen::Index count, const std::vector<double>& coefficients)
{
    Eigen::MatrixXd y(z.rows(), z.cols());
    for (Eigen::Index t = 0; t < z.cols(); ++t) {
        y.col(t) = z.col(z.cols() - 1 - t);
        for (std::size_t i = 0; i < coefficients.size(); ++i) {
            const Eigen::Index past = t - static_cast<Eigen::Index>(i) - 1;
            if (past >= 0)
                y.col(t) += coefficients[i] * y.col(past);
        }
    }
    return y.rightCols(count);
}

/// What the residuals' autocovariances are expected to lose to the parameters when `model` is true:
/// (E sum r[t] r[t - k] - (N - k) gamma[k]) / N with E r r' = (I - QQ') C (I - QQ').
std::vector<double> lostToParameters(const NoiseCandidate& model, const Eigen::MatrixXd& basis,
                                     std::size_t lags)
{
    AutoregressiveNoise noise = toNoise(model, 1);
    const Eigen::Index count = basis.cols();
    const Eigen::MatrixXd cq = model.variance * forward(backward(basis, noise), count, noise.coefficients);
    // sum over t of q[t]' Q C Q' q[t + k], less the two products of Q and C Q' with one of them moved.
    const Eigen::MatrixXd earlier = (cq * basis.transpose()) * basis - cq;
    std::vector<double> lost;
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        const auto shift = static_cast<Eigen::Index>(lag);
        const Eigen::Index rest = count - shift;
        const double sum = basis.rightCols(rest).cwiseProduct(earlier.leftCols(rest)).sum() -
                           basis.leftCols(rest).cwiseProduct(cq.rightCols(rest)).sum();
        lost.push_back(sum / static_cast<double>(count));
    }
    return lost;
}

/// r[lag] = mean of e[t] e[t - lag], in units of `scale`.
std::vector<double> autocovariances(std::span<const double> series, std::size_t lags, double scale)
{
    const auto count = static_cast<double>(series.size());
    std::vector<double> r(lags + 1, 0.0);
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        for (std::size_t i = lag; i < series.size(); ++i)
            r[lag] += (series[i] / scale) * (series[i - lag] / scale) / count;
    }
    return r;
}

} // namespace

AutoregressiveNoise fitAutoregressiveNoise(std::span<const double> residuals, const Eigen::MatrixXd& basis)
{
    const double scale = powerOfTwoScale(residuals);
    Eigen::VectorXd e(static_cast<Eigen::Index>(residuals.size()));
    for (Eigen::Index i = 0; i < e.size(); ++i)
        e(i) = residuals[static_cast<std::size_t>(i)] / scale;
    if (basis.size() == 0 && e.size() > 0)
        e.array() -= e.mean();
    const auto count = static_cast<double>(e.size());
    const std::size_t lags = std::min(largestNoiseOrder, residuals.size() / 10);
    if (e.size() == 0)
        return {};
    const std::vector<double> observed = autocovariances(e, lags);
    if (!(observed[0] > 0) || !std::isfinite(observed[0]))
        return {};
    std::vector<double> corrected = observed;
    NoiseCandidate model = bestByBic(corrected, count);
    if (basis.cols() != e.size() || residuals.size() > largestCorrected)
        return toNoise(model, scale);
    for (int i = 0; i < corrections && !model.coefficients.empty(); ++i) {
        const std::vector<double> lost = lostToParameters(model, basis, lags);
        for (std::size_t lag = 0; lag <= lags; ++lag)
            corrected[lag] = observed[lag] - lost[lag];
        if (!(corrected[0] > 0) || !std::isfinite(corrected[0]))
            break;
        model = bestByBic(corrected, count);
    }
    return toNoise(model, scale);
}

Eigen::MatrixXd whitened(const Eigen::MatrixXd& series, const AutoregressiveNoise& noise)
{
    Eigen::MatrixXd w = series;
    const auto order = static_cast<Eigen::Index>(noise.coefficients.size());
    for (Eigen::Index i = 0; i < std::min(order, series.cols() - 1); ++i) {
        const Eigen::Index rest = series.cols() - i - 1;
        w.rightCols(rest) -= noise.coefficients[static_cast<std::size_t>(i)] * series.leftCols(rest);
    }
    if (noise.movingAverage.empty())
        return w;
    for (Eigen::Index t = 0; t < series.cols(); ++t) {
        for (std::size_t j = 0; j < noise.movingAverage.size(); ++j) {
            const Eigen::Index past = t - static_cast<Eigen::Index>(j) - 1;
            if (past >= 0)
                w.col(t) -= noise.movingAverage[j] * w.col(past);
        }
    }
    return w;
}

std::vector<double> whitened(std::span<const double> series, const AutoregressiveNoise& noise)
{
    const Eigen::Map<const Eigen::RowVectorXd> row(series.data(), static_cast<Eigen::Index>(series.size()));
    const Eigen::MatrixXd w = whitened(Eigen::MatrixXd(row), noise);
    return {w.data(), w.data() + w.size()};
}

std::optional<RestrictedLikelihood> restrictedLikelihood(const Eigen::MatrixXd& series,
                                                         const AutoregressiveNoise& noise)
{
    const Eigen::Index parameters = series.rows() - 1;
    const Eigen::MatrixXd w = whitened(series, noise);
    const Eigen::MatrixXd gram = w * w.transpose();
    const Eigen::LLT<Eigen::MatrixXd> information(gram.topLeftCorner(parameters, parameters));
    const auto free = static_cast<double>(series.cols() - parameters);
    if (parameters < 0 || free < 1 || information.info() != Eigen::Success)
        return std::nullopt;
    const Eigen::VectorXd right = gram.col(parameters).head(parameters);
    const double rest = gram(parameters, parameters) - right.dot(information.solve(right));
    const double logDeterminant = 2 * Eigen::MatrixXd(information.matrixL()).diagonal().array().log().sum();
    RestrictedLikelihood found;
    found.variance = rest / free;
    found.minusTwiceLog = free * std::log(found.variance) + logDeterminant;
    if (!(rest > 0) || !std::isfinite(found.minusTwiceLog))
        return std::nullopt;
    return found;
}

double restrictedGain(std::span<const double> residuals, const Eigen::MatrixXd& basis,
                      const AutoregressiveNoise& noise)
{
    const auto count = static_cast<Eigen::Index>(residuals.size());
    if (basis.cols() != count)
        return 0;
    Eigen::MatrixXd series(basis.rows() + 1, count);
    series.topRows(basis.rows()) = basis;
    series.row(basis.rows()) = Eigen::Map<const Eigen::RowVectorXd>(residuals.data(), count);
    const auto white = restrictedLikelihood(series, {});
    const auto coloured = restrictedLikelihood(series, noise);
    return white && coloured ? 0.5 * (white->minusTwiceLog - coloured->minusTwiceLog) : 0;
}

Eigen::MatrixXd spreadUnderNoise(const Eigen::MatrixXd& columns, const AutoregressiveNoise& noise)
{
    const Eigen::MatrixXd z = noise.innovationDeviation * backward(columns, noise);
    return z * z.transpose();
}

Eigen::MatrixXd logSpreadSlopes(const Eigen::MatrixXd& rows, const AutoregressiveNoise& noise)
{
    // z[t] = x[t] + sum_i a_i z[t - i], so that dz[t]/da_i = v[t - i] with v filtered from z alike.
    const Eigen::MatrixXd z = backward(rows, noise);
    const auto order = static_cast<Eigen::Index>(noise.coefficients.size());
    Eigen::MatrixXd v = z;
    for (Eigen::Index t = 0; t < v.cols(); ++t)
        for (Eigen::Index i = 0; i < std::min(order, t); ++i)
            v.col(t) += noise.coefficients[static_cast<std::size_t>(i)] * v.col(t - i - 1);
    const Eigen::VectorXd squares = z.rowwise().squaredNorm();
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(z.rows(), order);
    for (Eigen::Index i = 0; i < std::min(order, z.cols() - 1); ++i) {
        const Eigen::Index rest = z.cols() - i - 1;
        const Eigen::VectorXd products = z.rightCols(rest).cwiseProduct(v.leftCols(rest)).rowwise().sum();
        slopes.col(i) = 2 * products.cwiseQuotient(squares);
    }
    return slopes;
}

std::optional<SeriesModel> autoregressiveModel(std::span<const double> series)
{
    if (series.empty() || !allFinite(series))
        return std::nullopt;
    const double scale = powerOfTwoScale(series);
    const auto count = static_cast<double>(series.size());
    const std::size_t orders = std::min(largestNoiseOrder, series.size() / 10);
    const std::vector<double> r = autocovariances(series, orders, scale);
    if (!(r[0] > 0))
        return std::nullopt;
    NoiseCandidate candidate = bestByBic(r, count);
    SeriesModel best;
    best.coefficients = std::move(candidate.coefficients);
    best.logLikelihood =
        -count / 2 * (std::log(2 * std::numbers::pi * candidate.variance) + 1) - count * std::log(scale);
    return std::isfinite(best.logLikelihood) ? std::optional(best) : std::nullopt;
}

} // namespace gripscope
