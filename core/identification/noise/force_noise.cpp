// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/identification/model/discretization.h"
#include "core/identification/noise/noise_model.h"
#include "core/identification/noise/residual_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace gripscope {

namespace {

/// The ratio of two variances needs no more residuals than this, whatever the length of the record.
constexpr Eigen::Index longestUsed = 20000;
/// Bounds of ln(force share / position share) of the residuals' variance: beyond them one of the two cannot
/// be seen. The grid's step is below the width of the likelihood.
constexpr double lowestLog = -10, highestLog = 8;
constexpr int gridPoints = 13;
constexpr int refinements = 14;

using Three = std::array<double, 3>;

/// Autocovariances at lags 0, 1, 2 of a moving average.
Three autocovariances(const Three& c)
{
    return {c[0] * c[0] + c[1] * c[1] + c[2] * c[2], c[0] * c[1] + c[1] * c[2], c[0] * c[2]};
}

struct MovingAverage {
    double c1 = 0, c2 = 0, variance = 0;
};

/// The moving average with these autocovariances whose inverse is stable, by Cholesky's decomposition of
/// their Toeplitz matrix row by row (Bauer 1955).
MovingAverage factor(const Three& r)
{
    constexpr int longest = 20000;
    constexpr double settled = 1e-13;
    double variance = r[0];
    double before = r[0];
    double c1 = r[1] / variance;
    double c2 = 0;
    double next = r[0] - c1 * c1 * variance;
    for (int i = 0; i < longest && next > 0; ++i) {
        before = variance;
        variance = next;
        const double c2New = r[2] / before;
        const double c1New = (r[1] - c2New * c1 * before) / variance;
        next = r[0] - c2New * c2New * before - c1New * c1New * variance;
        const double change = std::abs(c1New - c1) + std::abs(c2New - c2);
        c1 = c1New;
        c2 = c2New;
        if (change < settled)
            break;
    }
    return {c1, c2, next};
}

/// sum h[t]^2 of the response to one sample of force, as far as the record goes.
double responsePower(const ForceResponse& g, Eigen::Index count)
{
    double power = 0;
    double last = 0;
    double beforeLast = 0;
    for (Eigen::Index t = 0; t < count; ++t) {
        const double h =
            (t < 3 ? g.b[static_cast<std::size_t>(t)] : 0.0) - g.a[1] * last - g.a[2] * beforeLast;
        power += h * h;
        beforeLast = last;
        last = h;
    }
    return power;
}

/// The restricted likelihood over the one free number, logit = ln(share of the force / share of the
/// position).
class Likelihood {
public:
    Likelihood(std::span<const double> residuals, const Eigen::MatrixXd& basis, const ForceResponse& response)
        : m_parameters(basis.rows()), m_count(std::min(basis.cols(), longestUsed)),
          m_series(basis.rows() + 1, m_count), m_a(autocovariances(response.a)),
          m_b(autocovariances(response.b)), m_response(response), m_power(responsePower(response, m_count))
    {
        m_series.topRows(m_parameters) = basis.leftCols(m_count);
        for (Eigen::Index t = 0; t < m_count; ++t)
            m_series(m_parameters, t) = residuals[static_cast<std::size_t>(t)];
        m_white = evaluate({}, 1).value;
    }
    [[nodiscard]] bool usable() const
    {
        return m_power > 0 && std::isfinite(m_power) && std::isfinite(m_white);
    }

    struct Point {
        double value = std::numeric_limits<double>::infinity(); ///< -2 ln likelihood but for a constant
        AutoregressiveNoise noise;
    };
    [[nodiscard]] Point at(double logit) const
    {
        const double share = 1 / (1 + std::exp(-logit));
        Three r{};
        for (std::size_t i = 0; i < 3; ++i)
            r[i] = (1 - share) * m_a[i] + share / m_power * m_b[i];
        const MovingAverage average = factor(r);
        if (!(average.variance > 0))
            return {};
        AutoregressiveNoise noise;
        noise.coefficients = {-m_response.a[1], -m_response.a[2]};
        noise.movingAverage = {average.c1, average.c2};
        Point point = evaluate(noise, average.variance);
        if (!std::isfinite(point.value))
            return {};
        point.noise.forceDeviation = point.noise.innovationDeviation * std::sqrt(share / m_power);
        point.noise.innovationDeviation *= std::sqrt(average.variance);
        return point;
    }
    [[nodiscard]] double white() const { return m_white; }

private:
    [[nodiscard]] Point evaluate(const AutoregressiveNoise& noise, double variance) const
    {
        Point point;
        if (const auto found = restrictedLikelihood(m_series, noise)) {
            point.value = found->minusTwiceLog;
            point.noise = noise;
            // What is found is the innovations' variance, `variance` that of the model on its own scale.
            point.noise.innovationDeviation = std::sqrt(found->variance / variance);
        }
        return point;
    }

    Eigen::Index m_parameters, m_count;
    Eigen::MatrixXd m_series; ///< the basis and, last, the residual
    Three m_a, m_b;
    ForceResponse m_response;
    double m_power;
    double m_white = 0;
};

/// The smallest value: the best point of a grid, then golden sections around it.
double mostLikely(const Likelihood& likelihood)
{
    constexpr double step = (highestLog - lowestLog) / (gridPoints - 1);
    double best = lowestLog;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < gridPoints; ++i) {
        const double value = likelihood.at(lowestLog + i * step).value;
        if (value < least) {
            least = value;
            best = lowestLog + i * step;
        }
    }
    double left = std::max(best - step, lowestLog);
    double right = std::min(best + step, highestLog);
    constexpr double golden = 1 / std::numbers::phi;
    double inner = right - golden * (right - left);
    double outer = left + golden * (right - left);
    double atInner = likelihood.at(inner).value;
    double atOuter = likelihood.at(outer).value;
    for (int i = 0; i < refinements; ++i) {
        if (atInner < atOuter) {
            right = outer;
            outer = inner;
            atOuter = atInner;
            inner = right - golden * (right - left);
            atInner = likelihood.at(inner).value;
        } else {
            left = inner;
            inner = outer;
            atInner = atOuter;
            outer = left + golden * (right - left);
            atOuter = likelihood.at(outer).value;
        }
    }
    return 0.5 * (left + right);
}

/// From the curvature of the likelihood, which says how well the ratio is known, and the change of the
/// variances with it.
Eigen::Vector3d expansion(const Likelihood& likelihood, double logit, const Eigen::MatrixXd& basis,
                          const Eigen::MatrixXd& gains)
{
    constexpr double step = 0.3;
    const Likelihood::Point middle = likelihood.at(logit);
    const Likelihood::Point below = likelihood.at(logit - step);
    const Likelihood::Point above = likelihood.at(logit + step);
    const double curvature = (below.value - 2 * middle.value + above.value) / (step * step);
    Eigen::Vector3d factors = Eigen::Vector3d::Ones();
    const Eigen::Vector3d slope =
        (logVariances(basis, gains, above.noise) - logVariances(basis, gains, below.noise)) / (2 * step);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double spread =
            curvature > 0 ? slope(i) * slope(i) * 2 / curvature : std::numeric_limits<double>::infinity();
        factors(i) = errorExpansion(spread);
    }
    return factors;
}

} // namespace

ForceResponse forceResponse(const MassDampingStiffness& parameters, double sampleTime_s, ForceHold hold)
{
    const ExactStep<2> step = discretize(parameters, sampleTime_s, hold);
    const Eigen::Matrix2d& phi = step.phi;
    // x = C adj(z - phi) (gamma0 + gamma1 z) / det(z - phi) f
    const auto lowOrder = [&](const Eigen::Vector2d& g) { return phi(0, 1) * g(1) - phi(1, 1) * g(0); };
    ForceResponse response;
    response.a = {1, -phi.trace(), phi(0, 0) * phi(1, 1) - phi(0, 1) * phi(1, 0)};
    response.b = {step.gamma1(0), step.gamma0(0) + lowOrder(step.gamma1), lowOrder(step.gamma0)};
    return response;
}

std::optional<ForceNoiseFit> fitForceNoise(std::span<const double> residuals, const Eigen::MatrixXd& basis,
                                           const Eigen::MatrixXd& gains, const ForceResponse& response)
{
    if (basis.cols() != static_cast<Eigen::Index>(residuals.size()) || basis.cols() <= basis.rows() + 1)
        return std::nullopt;
    const Likelihood likelihood(residuals, basis, response);
    if (!likelihood.usable())
        return std::nullopt;
    const double logit = mostLikely(likelihood);
    const Likelihood::Point best = likelihood.at(logit);
    ForceNoiseFit fit;
    fit.noise = best.noise;
    fit.gain = 0.5 * (likelihood.white() - best.value);
    if (!std::isfinite(fit.gain) || !(best.noise.innovationDeviation > 0))
        return std::nullopt;
    fit.gain = std::max(fit.gain, 0.0);
    fit.expansion = expansion(likelihood, logit, basis, gains);
    return fit;
}

} // namespace gripscope
