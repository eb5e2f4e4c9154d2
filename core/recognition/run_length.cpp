// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/run_length.h"

#include "core/recognition/quiet_policy.h"

#include <Eigen/LU>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr int states = 60;
constexpr double leastWeight = 0.01;
constexpr double shortest = 5, longest = 1e6;
constexpr int halvings = 20;

/// P(|n|^2 <= x) for n ~ N(mean, I), |mean|^2 = `shift`.
double below(double x, double dimensions, double shift)
{
    if (!(x > 0))
        return 0;
    if (shift < 1e-12)
        return boost::math::cdf(boost::math::chi_squared_distribution<double, QuietPolicy>(dimensions), x);
    return boost::math::cdf(
        boost::math::non_central_chi_squared_distribution<double, QuietPolicy>(dimensions, shift), x);
}

} // namespace

std::optional<double> averageRunLength(double weight, int dimensions, double limit)
{
    if (!(weight >= leastWeight && weight <= 1) || dimensions < 1 || !(limit > 0) || !std::isfinite(limit))
        return {};
    // |e| from 0 to its limit in rings; the innermost is a disc of half the width.
    const double radius = std::sqrt(limit * weight / (2 - weight));
    const double width = radius / (states - 0.5);
    Eigen::MatrixXd remaining = Eigen::MatrixXd::Identity(states, states);
    for (int from = 0; from < states; ++from) {
        const double shift = std::pow((1 - weight) * from * width / weight, 2);
        double inner = 0;
        for (int to = 0; to < states; ++to) {
            const double outer = below(std::pow((to + 0.5) * width / weight, 2), dimensions, shift);
            remaining(from, to) -= outer - inner;
            inner = outer;
        }
    }
    const Eigen::VectorXd lengths = remaining.partialPivLu().solve(Eigen::VectorXd::Ones(states));
    return std::isfinite(lengths(0)) && lengths(0) >= 1 ? std::optional(lengths(0)) : std::nullopt;
}

std::optional<double> movingAverageLimit(double weight, int dimensions, double averageLength)
{
    if (!(averageLength >= shortest && averageLength <= longest))
        return {};
    double low = 0.01, high = 60.0 + 3 * std::max(1, dimensions);
    for (int halving = 0; halving < halvings; ++halving) {
        const double middle = (low + high) / 2;
        const std::optional<double> found = averageRunLength(weight, dimensions, middle);
        if (!found && middle < 1)
            return {};
        (found && *found < averageLength ? low : high) = middle;
    }
    return high;
}

} // namespace gripscope
