// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/motion_search.h"
#include "core/identification/noise/noise_model.h"
#include "core/identification/noise/residual_noise.h"
#include "core/math/decompositions.h"
#include "core/math/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

using P = MotionParameter;

/// One-sided 95 % of the normal distribution.
constexpr double oneSided95 = 1.6448536269514722;

} // namespace

Eigen::VectorXd errorScales(const MotionProblem& problem, const MotionPoint& point)
{
    const std::vector<P> parameters = problem.terms.parameters();
    Eigen::VectorXd scales(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i)
        scales(static_cast<Eigen::Index>(i)) =
            problem.unitOf(parameters[i]) * (isPositive(parameters[i]) ? point.values[parameters[i]] : 1.0);
    return scales;
}

Eigen::MatrixXd influencesOf(const MotionProblem& problem, const MotionSearchResult& search,
                             const MotionRows& rows, const Eigen::VectorXd& scales)
{
    const std::vector<Eigen::Index> moving = search.linear.moving();
    const Eigen::MatrixXd inverse = inverseOfTriangle(triangleOf(search.linear.triangle(Eigen::all, moving)));
    const Eigen::MatrixXd gains =
        scales.asDiagonal() * inverse.bottomRows(scales.size()) * inverse.transpose() / problem.positionScale;
    const Eigen::MatrixXd measured = rows.sensitivities(Eigen::all, moving) * gains.transpose();
    Eigen::MatrixXd all =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(problem.position.size()), scales.size());
    Eigen::Index row = 0;
    for (std::ptrdiff_t i = problem.firstRow(); i < problem.endRow() && row < measured.rows(); ++i)
        if (!problem.isLost(i))
            all.row(i) = measured.row(row++);
    return all;
}

std::optional<Eigen::MatrixXd> whiteCovariance(const MotionProblem& problem, const MotionSearchResult& search,
                                               const Eigen::VectorXd& scales)
{
    const Eigen::MatrixXd columns = search.linear.triangle(Eigen::all, search.linear.moving());
    const Eigen::MatrixXd inverse = inverseOfTriangle(triangleOf(columns));
    const Eigen::MatrixXd root = scales.asDiagonal() * inverse.bottomRows(scales.size());
    // Positions that are explained to the last bit are still rounded there.
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    const double squares = std::max(search.cost(), rounding * rounding * squaredSize(problem));
    return usableCovariance(squares / MotionSearchResult::degreesOfFreedom(problem) * root *
                            root.transpose());
}

Eigen::MatrixXd withKnownFriction(const Eigen::MatrixXd& covariance, Eigen::Index friction, double variance)
{
    const Eigen::VectorXd column = covariance.col(friction);
    return covariance - column * column.transpose() / (column(friction) + variance);
}

std::optional<Eigen::MatrixXd> colouredCovariance(const MotionRows& rows, const Eigen::VectorXd& scales,
                                                  double positionScale, Estimate& estimate)
{
    // A start that moves nothing is left out; the parameters come last.
    const OrthonormalRows orthonormal = orthonormalize(rows.sensitivities.transpose(), {});
    const Eigen::Index kept = orthonormal.basis.rows();
    if (kept < scales.size() || orthonormal.kept[static_cast<std::size_t>(kept - scales.size())] !=
                                    rows.sensitivities.cols() - scales.size())
        return std::nullopt;
    AutoregressiveNoise noise = fitAutoregressiveNoise(rows.residuals, orthonormal.basis);
    if (noise.coefficients.empty())
        return std::nullopt;
    Eigen::MatrixXd gains = Eigen::MatrixXd::Identity(orthonormal.basis.rows(), orthonormal.basis.rows());
    orthonormal.factor.transpose().triangularView<Eigen::Upper>().solveInPlace(gains);
    gains = (scales.asDiagonal() * gains.bottomRows(scales.size())).eval();
    const Eigen::VectorXd expansion = autoregressiveExpansion(orthonormal.basis, gains, noise);
    const Eigen::MatrixXd scaled = expansion.asDiagonal() * gains;
    const auto covariance =
        usableCovariance(scaled * spreadUnderNoise(orthonormal.basis, noise) * scaled.transpose());
    if (!covariance)
        return std::nullopt;
    noise.innovationDeviation *= positionScale;
    estimate.noise = noise;
    return covariance;
}

std::optional<double> frictionLimit(const MotionProblem& problem, const MotionSearchResult& search,
                                    const MotionValues& found, const Eigen::MatrixXd& covariance)
{
    const std::vector<P> parameters = problem.terms.parameters();
    const auto at = std::ranges::find(parameters, P::Friction);
    if (at == parameters.end())
        return std::nullopt;
    const Eigen::Index index = at - parameters.begin();
    double best = found[P::Friction];
    if (best == 0) {
        const Eigen::MatrixXd columns = search.linear.triangle(Eigen::all, search.linear.moving());
        const Eigen::VectorXd step = solvePivoted(columns, search.linear.residual).solution;
        const auto fromEnd = static_cast<Eigen::Index>(parameters.size()) - index;
        best = std::min(0.0, step(step.size() - fromEnd)) * problem.unitOf(P::Friction);
    }
    return std::max(0.0, best + oneSided95 * std::sqrt(covariance(index, index)));
}

} // namespace gripscope
