// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/early/linearized_evidence.h"

#include "core/math/decompositions.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

ReducedRecord reduceRecord(const LaggedProducts& products, double pole, double ridge)
{
    LaggedProducts::Matrix all = products.whitened(pole);
    const Eigen::Index nuisances = all.rows() - 4;
    ReducedRecord reduced;
    for (Eigen::Index i = 0; i < nuisances; ++i) {
        all(i, i) += ridge;
        const double pivot = all(i, i);
        reduced.logDeterminant += std::log(pivot);
        const Eigen::Index below = all.rows() - i - 1;
        const LaggedProducts::Matrix column = all.block(i + 1, i, below, 1);
        all.bottomRightCorner(below, below).noalias() -= column * (column.transpose() / pivot);
    }
    reduced.information = all.block<3, 3>(nuisances, nuisances);
    reduced.slope = all.block<3, 1>(nuisances, nuisances + 3);
    reduced.residual = std::max(all(nuisances + 3, nuisances + 3), 0.0);
    return reduced;
}

LinearizedEvidence linearizedEvidence(const LaggedProducts& products, const LogPrior& prior,
                                      std::span<const NoiseNode> noise, double ridge)
{
    LinearizedEvidence evidence;
    double best = -std::numeric_limits<double>::infinity();
    const Eigen::Matrix3d spread = prior.covariance.llt().matrixL();
    const auto rows = static_cast<double>(products.rows() - (products.columns() - 4));
    const auto stretches = static_cast<double>(products.stretches());
    for (const NoiseNode& node : noise) {
        const ReducedRecord record = reduceRecord(products, node.pole, ridge);
        const Eigen::Vector3d slope = record.slope - record.information * prior.shift;
        const double residual = record.residual - (record.slope + slope).dot(prior.shift);
        // In the prior's own axes, in which it is a unit sphere, the information is diagonal.
        const SymmetricAxes axes = symmetricAxes(spread.transpose() * record.information * spread);
        const Eigen::Array3d information = axes.values.array().max(0.0);
        const Eigen::Array3d along = (axes.directions.transpose() * (spread.transpose() * slope)).array();
        const double pole = stretches / 2 * std::log1p(-node.pole * node.pole) - record.logDeterminant / 2;
        for (const double deviation : node.deviations) {
            const double variance = deviation * deviation;
            const Eigen::Array3d step = along / (information + variance);
            const double misfit = std::max(residual - (along * step).sum(), 0.0);
            const double log = pole - rows * std::log(deviation) -
                               (1 + information / variance).log().sum() / 2 - misfit / (2 * variance);
            evidence.log.push_back(log);
            if (log > best) {
                best = log;
                evidence.step = prior.shift + spread * (axes.directions * step.matrix());
            }
        }
    }
    return evidence;
}

} // namespace gripscope
