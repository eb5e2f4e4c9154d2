// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/own_spread.h"

#include "core/math/decompositions.h"
#include "core/math/distributions.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

/// Less p. Enough candidates that the best lies within a fifth in spread of the true one; the first is the
/// least with a mean and some margin.
constexpr std::array<double, 10> likenesses{3, 5, 7, 10, 15, 22, 32, 47, 72, 117};
constexpr double leastSpreadGain = 2;

/// log(Gamma_p((likeness + f) / 2) / Gamma_p(likeness / 2)) of the multivariate gamma function in p
/// dimensions.
double logGammaRatio(double likeness, double f, Eigen::Index p)
{
    double sum = 0;
    for (Eigen::Index i = 0; i < p; ++i)
        sum += logGamma((likeness + f - double(i)) / 2) - logGamma((likeness - double(i)) / 2);
    return sum;
}

/// Logarithm of the marginal density of A, less that of one shared covariance; `gammas` of logGammaRatio().
double logLikelihoodGain(const OwnScatter& type, double likeness, double gammas)
{
    const double f = type.degreesOfFreedom;
    const Eigen::Index p = type.sum.rows();
    const auto dimensions = double(p);
    const double scale = likeness - dimensions - 1;
    const LogMatrix sum = scale * LogMatrix::Identity(p, p) + type.sum;
    const double own = gammas + likeness / 2 * dimensions * std::log(scale) -
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
    if (scatters.empty())
        return likeness;
    for (const double beyond : likenesses) {
        const double candidate = beyond + double(scatters.front().sum.rows());
        double gain = 0;
        double degrees = 0, gammas = 0; // most types have as many squeezes as the one before
        for (const OwnScatter& scatter : scatters) {
            if (!(scatter.degreesOfFreedom > 0))
                continue;
            if (scatter.degreesOfFreedom != degrees) {
                degrees = scatter.degreesOfFreedom;
                gammas = logGammaRatio(candidate, degrees, scatter.sum.rows());
            }
            gain += logLikelihoodGain(scatter, candidate, gammas);
        }
        if (gain > best) {
            best = gain;
            likeness = candidate;
        }
    }
    return likeness;
}

LogMatrix ownCovariance(const OwnScatter& type, double likeness)
{
    const Eigen::Index p = type.sum.rows();
    return ((likeness - double(p) - 1) * LogMatrix::Identity(p, p) + type.sum) /
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

/// The t of tr((t I + C)^-1 W) = p, for W that is nowhere less than C.
double variance(const LogMatrix& total, const LogMatrix& noise)
{
    const SmallSymmetricAxes eigen = smallSymmetricAxes(noise);
    const LogVector known = eigen.values.cwiseMax(0);
    const LogVector found = (eigen.directions.transpose() * total * eigen.directions).diagonal();
    double low = leastScatterVariance, high = std::max(leastScatterVariance, found.mean());
    for (int halving = 0; halving < halvings; ++halving) {
        const double middle = (low + high) / 2;
        const double trace = found.cwiseQuotient((known.array() + middle).matrix()).sum();
        (trace > double(total.rows()) ? low : high) = middle;
    }
    return high;
}

} // namespace

std::optional<double> alikeVariance(const Scatter& scatter)
{
    if (!(scatter.degreesOfFreedom > 0))
        return {};
    const Eigen::Index p = scatter.total.rows();
    const LogMatrix noise = scatter.noiseKnown ? scatter.noise : LogMatrix::Zero(p, p).eval();
    const double found = variance(scatter.total, noise);
    const Eigen::LLT<LogMatrix> alike(noise + found * LogMatrix::Identity(p, p));
    if (alike.info() != Eigen::Success)
        return {};
    const LogMatrix half = alike.matrixL().solve(scatter.total);
    OwnScatter seen;
    seen.sum = scatter.degreesOfFreedom * alike.matrixL().solve(half.transpose().eval());
    seen.degreesOfFreedom = scatter.degreesOfFreedom;
    return likelyDegrees({seen}) ? std::nullopt : std::optional(found);
}

} // namespace gripscope
