// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/own_spread.h"

#include <Eigen/LU>
#include <boost/math/special_functions/gamma.hpp> // std::lgamma writes a global

#include <array>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

constexpr double dimensions = 3;
/// Enough candidates that the best lies within a fifth in spread of the true one; the first is the least
/// with a mean and some margin.
constexpr std::array<double, 10> candidates{6, 8, 10, 13, 18, 25, 35, 50, 75, 120};
constexpr double leastGain = 2;

/// Logarithm of the multivariate gamma function in 3 dimensions, up to a constant.
double logGamma3(double a)
{
    return boost::math::lgamma(a) + boost::math::lgamma(a - 0.5) + boost::math::lgamma(a - 1);
}

/// Logarithm of the marginal density of A, less that of one shared covariance.
double logLikelihoodGain(const OwnScatter& type, double likeness)
{
    const double f = type.degreesOfFreedom;
    const double scale = likeness - dimensions - 1;
    const Eigen::Matrix3d sum = scale * Eigen::Matrix3d::Identity() + type.sum;
    const double own = logGamma3((likeness + f) / 2) - logGamma3(likeness / 2) +
                       likeness / 2 * dimensions * std::log(scale) -
                       (likeness + f) / 2 * std::log(sum.determinant());
    const double shared = -dimensions * f / 2 * std::numbers::ln2 - type.sum.trace() / 2;
    return own - shared;
}

} // namespace

std::optional<double> degreesOfLikeness(const std::vector<OwnScatter>& types)
{
    return types.size() < 2 ? std::nullopt : likelyDegrees(types);
}

std::optional<double> likelyDegrees(const std::vector<OwnScatter>& scatters)
{
    double best = leastGain;
    std::optional<double> likeness;
    for (const double candidate : candidates) {
        double gain = 0;
        for (const OwnScatter& scatter : scatters)
            if (scatter.degreesOfFreedom > 0)
                gain += logLikelihoodGain(scatter, candidate);
        if (gain > best) {
            best = gain;
            likeness = candidate;
        }
    }
    return likeness;
}

Eigen::Matrix3d ownCovariance(const OwnScatter& type, double likeness)
{
    return ((likeness - dimensions - 1) * Eigen::Matrix3d::Identity() + type.sum) /
           (likeness + type.degreesOfFreedom);
}

double ownDegreesOfFreedom(const OwnScatter& type, double likeness, double shared, double types)
{
    const double own = likeness + type.degreesOfFreedom;
    const double fromShared = likeness / own;
    return 1 / (1 / own + fromShared * fromShared * (1 / shared + 1 / (likeness * types)));
}

} // namespace gripscope
