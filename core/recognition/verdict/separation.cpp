// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/distributions.h"
#include "core/recognition/verdict/judgement.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gripscope {

namespace {

constexpr double leastDistance = 1e-9;
/// Beyond so many times the distance that is needed, a type is not taken for the other at any rate that
/// matters.
constexpr double outOfReach = 3;
/// Degrees of freedom of the prior that scatter is alike, at most. As many as four types of 3 squeezes have,
/// where it makes nine tenths of an oracle's names possible; twice as many add a fiftieth.
constexpr double mostPriorDegrees = 8;

/// Up to as many the rate is kept without what is small there: the error of S in the turn by the mean's
/// error, and the tail of X.
constexpr double fewDimensions = 3;

/// Where two types are held against each other, and how well the variance there is known.
struct Axis {
    LogVector along;             ///< u
    double variance = 0;         ///< u' S u
    double degreesOfFreedom = 0; ///< of Student's t
    double widening = 1;         ///< t times this, for a mean that is exact
    double across = 0;           ///< of it, over n D, is the turn by the error of the mean
    double directions =
        0; ///< X has more of a tail than its mean: chi-square of so many; 0: it does not count
};

/// Scatter of any shape.
std::optional<Axis> freeAxis(const TypePrediction& named, const TypePrediction& other)
{
    const double v = other.degreesOfFreedom;
    const auto p = double(other.meanLog.size());
    if (!(v >= p))
        return {};
    const Eigen::LLT<LogMatrix> cholesky((named.covariance + other.covariance) / 2);
    const LogVector difference = named.meanLog - other.meanLog;
    Axis axis;
    axis.along = cholesky.solve(difference);
    axis.variance = difference.dot(axis.along);
    axis.degreesOfFreedom = v - (p - 1);
    const double direction = 1 + (p - 1) / std::max(1.0, v - p);
    axis.widening = std::sqrt(direction * v / axis.degreesOfFreedom);
    axis.across = p - 1;
    if (p > fewDimensions) {
        axis.across *= v / axis.degreesOfFreedom;
        axis.directions = p - 1;
    }
    return axis;
}

/// Scatter that may be alike in all coordinates.
std::optional<Axis> alikeAxis(const TypePrediction& named, const TypePrediction& other)
{
    const double v = other.degreesOfFreedom;
    const auto p = double(other.meanLog.size());
    if (!(v >= p))
        return {};
    const double prior = std::min(mostPriorDegrees, v);
    const double w = prior / (prior + v);
    const LogMatrix blend = w * *other.alikeCovariance + (1 - w) * other.covariance;
    Axis axis;
    axis.along = other.alikeCovariance->llt().solve(named.meanLog - other.meanLog);
    axis.variance = axis.along.dot(blend * axis.along);
    axis.degreesOfFreedom = p * v / (p - 2 * (p - 1) * w + (p - 1) * w * w);
    axis.across = p - 1;
    return axis;
}

/// What X = 1 + chi2_c / chi2_{f+1} does to a quantile of Student(f) beyond what its mean does:
///     (E X^r)^(1/(2 r)) / (E X)^(1/2),
/// where the probability beyond t falls as t^(-2 r) there. 1 / X has a beta distribution.
double tailOfDirection(double quantile, double f, double c, double rate)
{
    constexpr double step = 1.01;
    const double r = std::log(rate / studentAbove(step * quantile, f)) / (2 * std::log(step));
    const double shape = (f + 1) / 2;
    if (!(r > 0 && r < shape))
        return 1;
    const double logMoment =
        logGamma(shape - r) + logGamma(shape + c / 2) - logGamma(shape) - logGamma(shape + c / 2 - r);
    return std::max(1.0, std::sqrt(std::exp(logMoment / r) / (1 + c / std::max(1.0, f - 1))));
}

/// How many deviations beyond an exact mean a squeeze gets with a probability of `rate`.
std::optional<double> quantileAlong(double degreesOfFreedom, double directions, double rate, bool robust)
{
    double quantile = studentQuantileAbove(rate, degreesOfFreedom);
    if (directions > 0 && rate < 0.5 && std::isfinite(quantile))
        quantile *= tailOfDirection(quantile, degreesOfFreedom, directions, rate);
    if (robust && rate < 0.5) {
        constexpr double tail = 5; // of unit variance
        quantile *= std::max(1.0, std::sqrt((tail - 2) / tail) * studentQuantileAbove(rate, tail) /
                                      normalQuantileAbove(rate));
    }
    return std::isfinite(quantile) ? std::optional(quantile) : std::nullopt;
}

/// quantileAlong(), each once: most types have the same degrees of freedom.
class Quantiles {
public:
    Quantiles(double rate, bool robust) : m_rate(rate), m_robust(robust) {}
    std::optional<double> operator()(double degreesOfFreedom, double directions)
    {
        const std::pair key(degreesOfFreedom, directions);
        const auto found = m_known.find(key);
        if (found != m_known.end())
            return found->second;
        return m_known[key] = quantileAlong(degreesOfFreedom, directions, m_rate, m_robust);
    }

private:
    double m_rate;
    bool m_robust;
    std::map<std::pair<double, double>, std::optional<double>> m_known;
};

/// A Separation at any rate.
class AnyRate {
public:
    AnyRate(const TypePrediction& named, const TypePrediction& other, const LogVector& log)
        : m_effectiveSqueezes(other.effectiveSqueezes)
    {
        const bool alike = other.alikeCovariance.has_value();
        const std::optional<Axis> axis = alike ? alikeAxis(named, other) : freeAxis(named, other);
        if (!axis)
            return;
        const double deviation = std::sqrt(axis->variance);
        m_found.distance = axis->along.dot(named.meanLog - other.meanLog) / deviation;
        m_found.reached = axis->along.dot(log - other.meanLog) / deviation;
        m_widening = std::sqrt(1 + 1 / m_effectiveSqueezes) * axis->widening;
        m_degreesOfFreedom = axis->degreesOfFreedom;
        m_across = axis->across;
        m_directions = axis->directions;
    }
    [[nodiscard]] std::optional<Separation> at(Quantiles& rate) const
    {
        if (!(m_found.distance > leastDistance))
            return {};
        const std::optional<double> quantile = rate(m_degreesOfFreedom, m_directions);
        if (!quantile)
            return {};
        Separation result = m_found;
        result.needed =
            m_widening * *quantile + m_across / (m_effectiveSqueezes * std::max(1.0, m_found.distance));
        return result;
    }

private:
    Separation m_found; ///< a distance of 0: there is none
    double m_effectiveSqueezes, m_widening = 0, m_degreesOfFreedom = 0, m_across = 0, m_directions = 0;
};

} // namespace

std::optional<Separation> separation(const std::vector<TypePrediction>& predictions, std::size_t named,
                                     std::size_t other, const LogVector& log, double rate, bool robust)
{
    Quantiles quantiles(rate, robust);
    return AnyRate(predictions[named], predictions[other], log).at(quantiles);
}

NamingTest testNaming(const std::vector<TypePrediction>& predictions, std::size_t named, const LogVector& log,
                      const SeparationOptions& options)
{
    NamingTest test;
    Quantiles alone(options.wrongType, options.robust);
    std::vector<AnyRate> anyRate;
    anyRate.reserve(predictions.size());
    int near = 0;
    for (std::size_t other = 0; other < predictions.size(); ++other) {
        anyRate.emplace_back(predictions[named], predictions[other], log);
        if (other == named)
            continue;
        const std::optional<Separation> found = anyRate.back().at(alone);
        near += !found || found->distance < outOfReach * found->needed;
    }
    Quantiles shared(options.wrongType / std::max(1, near), options.robust);
    Quantiles& rate = near > 1 ? shared : alone; // a quantile is the dearest part of a verdict
    double least = 0;
    test.passed = true;
    for (std::size_t other = 0; other < predictions.size(); ++other) {
        if (other == named)
            continue;
        const std::optional<Separation> found = anyRate[other].at(rate);
        const double margin = found ? found->reached - found->needed : -1e300;
        if (!(margin > 0)) {
            test.passed = false;
            test.open.push_back(other);
        }
        if (!test.rival || margin < least) {
            least = margin;
            test.rival = other;
        }
    }
    return test;
}

std::optional<double> timesLonger(const TypeModels& models, std::size_t one, std::size_t other,
                                  const LogMatrix& noise, const SeparationOptions& options)
{
    constexpr double most = 100;
    constexpr double nineOfTen = 1.2816; // quantile of the normal distribution
    const LogVector log = models.types[one].meanLog;
    const auto enough = [&](double times) {
        const auto predictions = predictTypes(models, log, LogMatrix(noise / times), {options.robust});
        const auto found = separation(predictions, one, other, log, options.wrongType, options.robust);
        return found && found->distance - nineOfTen > found->needed;
    };
    if (enough(1))
        return 1.0;
    if (!enough(most))
        return {};
    double low = 1, high = most;
    for (int halving = 0; halving < 12; ++halving) {
        const double middle = std::sqrt(low * high);
        (enough(middle) ? high : low) = middle;
    }
    return high;
}

} // namespace gripscope
