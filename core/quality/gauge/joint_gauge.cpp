// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/gauge_study.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// Less than this of a value's repeatability not explained by the others: they determine it.
constexpr double singularGauge = 1e-10;

using SymmetricSolver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

/// The part of a symmetric matrix along its positive axes.
Eigen::MatrixXd positivePart(const Eigen::MatrixXd& matrix, bool* projected = nullptr)
{
    const SymmetricSolver axes(matrix);
    const double rounding = 1e-12 * std::max(1.0, axes.eigenvalues().cwiseAbs().maxCoeff());
    if (projected != nullptr)
        *projected = axes.eigenvalues().minCoeff() < -rounding;
    return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).asDiagonal() *
           axes.eigenvectors().transpose();
}

} // namespace

std::optional<JointGauge> jointGauge(const SourceSums& sums)
{
    const std::vector<Eigen::MatrixXd> covariances = sums.momentCovariances();
    const Eigen::MatrixXd& repeatability = covariances.back();
    const Eigen::VectorXd scale = repeatability.diagonal().cwiseMax(0).cwiseSqrt();
    if (!(scale.minCoeff() > 0))
        return std::nullopt;
    const Eigen::MatrixXd correlation =
        scale.cwiseInverse().asDiagonal() * repeatability * scale.cwiseInverse().asDiagonal();
    const SymmetricSolver spread(correlation);
    if (spread.eigenvalues().minCoeff() < singularGauge)
        return std::nullopt;
    // In these coordinates repeatability is the identity.
    const Eigen::MatrixXd whiten = spread.operatorInverseSqrt() * scale.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd back = scale.asDiagonal() * spread.operatorSqrt();
    JointGauge joint;
    Eigen::MatrixXd part, gauge = Eigen::MatrixXd::Identity(scale.size(), scale.size());
    for (std::size_t l = 0; l + 1 < covariances.size(); ++l) {
        const Eigen::MatrixXd white = whiten * covariances[l] * whiten.transpose();
        if (sums.sources[l] == GaugeSource::Part)
            part = positivePart(white, &joint.partProjected);
        else
            gauge += positivePart(white);
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> axes(part, gauge);
    for (Eigen::Index i = scale.size(); i-- > 0;) {
        JointDirection direction;
        direction.ratio = std::max(0.0, axes.eigenvalues()[i]);
        direction.kinds = std::sqrt(1 + 2 * direction.ratio);
        direction.weights = whiten.transpose() * axes.eigenvectors().col(i);
        Eigen::Index largest = 0;
        direction.weights.cwiseProduct(scale).cwiseAbs().maxCoeff(&largest);
        if (direction.weights[largest] < 0)
            direction.weights = -direction.weights;
        joint.kinds *= direction.kinds;
        joint.directions.push_back(std::move(direction));
    }
    joint.part = back * part * back.transpose();
    joint.gauge = back * gauge * back.transpose();
    return joint;
}

} // namespace gripscope
