// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/own_spread.h"

#include "core/math/decompositions.h"
#include "core/math/distributions.h"
#include "core/recognition/types/dimensions.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

/// Enough candidates that the best lies within a fifth in spread of the true one; the first is the least
/// with a mean and some margin.
constexpr std::array<double, 10> likenesses{6, 8, 10, 13, 18, 25, 35, 50, 75, 120};
constexpr double leastSpreadGain = 2;

/// Logarithm of the multivariate gamma function in 3 dimensions, up to a constant.
double logGamma3(double a)
{
    return logGamma(a) + logGamma(a - 0.5) + logGamma(a - 1);
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
    double best = leastSpreadGain;
    std::optional<double> likeness;
    for (const double candidate : likenesses) {
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

namespace {

constexpr int halvings = 60;
constexpr double leastScatterVariance = 1e-8; ///< as small as any scatter is taken for

/// The t of tr((t I + C)^-1 W) = 3, for W that is nowhere less than C.
double variance(const Eigen::Matrix3d& total, const Eigen::Matrix3d& noise)
{
    const SymmetricAxes eigen = symmetricAxes(noise);
    const Eigen::Vector3d known = eigen.values.cwiseMax(0);
    const Eigen::Vector3d found = (eigen.directions.transpose() * total * eigen.directions).diagonal();
    double low = leastScatterVariance, high = std::max(leastScatterVariance, found.mean());
    for (int halving = 0; halving < halvings; ++halving) {
        const double middle = (low + high) / 2;
        const double trace = found.cwiseQuotient((known.array() + middle).matrix()).sum();
        (trace > 3 ? low : high) = middle;
    }
    return high;
}

} // namespace

std::optional<double> alikeVariance(const Scatter& scatter)
{
    if (!(scatter.degreesOfFreedom > 0))
        return {};
    const Eigen::Matrix3d noise = scatter.noiseKnown ? scatter.noise : Eigen::Matrix3d::Zero().eval();
    const double found = variance(scatter.total, noise);
    const Eigen::LLT<Eigen::Matrix3d> alike(noise + found * Eigen::Matrix3d::Identity());
    if (alike.info() != Eigen::Success)
        return {};
    const Eigen::Matrix3d half = alike.matrixL().solve(scatter.total);
    OwnScatter seen;
    seen.sum = scatter.degreesOfFreedom * alike.matrixL().solve(half.transpose().eval());
    seen.degreesOfFreedom = scatter.degreesOfFreedom;
    return likelyDegrees({seen}) ? std::nullopt : std::optional(found);
}

} // namespace gripscope
