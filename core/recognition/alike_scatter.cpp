// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/alike_scatter.h"

#include "core/recognition/own_spread.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>

namespace gripscope {

namespace {

constexpr int halvings = 60;
constexpr double leastVariance = 1e-8; ///< as small as any scatter is taken for

/// The t of tr((t I + C)^-1 W) = 3, for W that is nowhere less than C.
double variance(const Eigen::Matrix3d& total, const Eigen::Matrix3d& noise)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(noise);
    const Eigen::Vector3d known = eigen.eigenvalues().cwiseMax(0);
    const Eigen::Vector3d found =
        (eigen.eigenvectors().transpose() * total * eigen.eigenvectors()).diagonal();
    double low = leastVariance, high = std::max(leastVariance, found.mean());
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
