// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing/duffing_model.h"
#include "core/identification/output_error/output_error.h"
#include "core/identification/validation/validation_contrast.h"
#include "core/math/fit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr int mostRounds = 30, mostHalvings = 20;
/// Share of the sum of squares that a further round must be worth.
constexpr double worthwhile = 1e-12;
/// A method of order 4 in steps of a twelfth of a radian: 1e-6 of the motion.
constexpr int finerSteps = 4;

/// The step of x0, v0 and offset that fits the residuals best, and none of the parameters.
Eigen::VectorXd nuisanceStep(const DuffingProblem& problem, const DuffingRows& rows)
{
    const Eigen::Index free = problem.nuisanceCount();
    const Eigen::Map<const Eigen::VectorXd> residual(rows.residuals.data(),
                                                     static_cast<Eigen::Index>(rows.residuals.size()));
    const Eigen::MatrixXd columns = rows.sensitivities.leftCols(free);
    const Eigen::VectorXd scales = columns.colwise().norm().transpose().cwiseMax(1e-300).cwiseInverse();
    const Eigen::MatrixXd normal =
        scales.asDiagonal() * (columns.transpose() * columns) * scales.asDiagonal();
    const Eigen::VectorXd right = scales.asDiagonal() * (columns.transpose() * residual);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(problem.unknowns());
    step.head(free) = scales.asDiagonal() * Eigen::VectorXd(normal.colPivHouseholderQr().solve(right));
    return step;
}

/// Gauss-Newton in x0, v0 and offset; one round where the spring is straight, since they enter linearly.
std::optional<DuffingPoint> fitNuisances(const DuffingProblem& problem, DuffingPoint point)
{
    std::optional<double> cost = costAt(problem, point);
    for (int round = 0; cost && round < mostRounds; ++round) {
        Eigen::VectorXd step = nuisanceStep(problem, duffingRows(problem, point));
        if (!step.allFinite())
            return std::nullopt;
        const double before = *cost;
        for (int halving = 0; halving < mostHalvings; ++halving, step /= 2) {
            const DuffingPoint trial = point.moved(problem, step);
            const std::optional<double> there = costAt(problem, trial);
            if (there && *there < *cost) {
                point = trial;
                cost = there;
                break;
            }
        }
        if (!(before - *cost > worthwhile * before))
            break;
    }
    return cost ? std::optional(point) : std::nullopt;
}

/// From where a straight spring would start, which is near enough for one that is not.
std::optional<DuffingPoint> fittedPoint(DuffingProblem& problem, const MassDampingStiffness& parameters,
                                        double k3)
{
    DuffingPoint point;
    point.theta = problem.toTheta(parameters);
    problem.substeps = suitableSubsteps(point, 0);
    std::optional<DuffingPoint> fitted = fitNuisances(problem, point);
    if (!fitted || k3 == 0)
        return fitted;
    double reach = 0;
    for (const double y : problem.position)
        reach = std::max(reach, std::abs(y - fitted->offset));
    fitted->cubic = k3 / cubicUnit(problem);
    problem.substeps = finerSteps * suitableSubsteps(*fitted, reach);
    return fitNuisances(problem, *fitted);
}

} // namespace

std::optional<GivenModel> applyGivenModel(const MassDampingStiffness& parameters, double k3,
                                          const PreparedRecord& record, ForceHold hold)
{
    ContinuousTimeOptions options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = hold;
    options.lag_s = record.forceLag_s;
    if (record.force.empty() || record.force.size() != record.position.size() ||
        !(parameters.vector().minCoeff() > 0) || !parameters.vector().allFinite() || !std::isfinite(k3))
        return std::nullopt;
    DuffingProblem problem{makeOutputErrorProblem(record.force, record.position, options), 1};
    if (problem.rows() <= problem.unknowns())
        return std::nullopt;
    const std::optional<DuffingPoint> point = fittedPoint(problem, parameters, k3);
    if (!point)
        return std::nullopt;

    const DuffingRows rows = duffingRows(problem, *point);
    const Eigen::Index free = problem.nuisanceCount();
    GivenModel model;
    model.nuisances = rows.sensitivities.leftCols(free).transpose();
    model.parameters = rows.sensitivities.middleCols(free, k3 == 0 ? 3 : 4).transpose();
    if (k3 != 0)
        model.parameters.row(3) /= cubicUnit(problem);
    model.residual = Eigen::Map<const Eigen::RowVectorXd>(rows.residuals.data(),
                                                          static_cast<Eigen::Index>(rows.residuals.size()));
    model.simulated = positionsAt(problem, *point);
    for (double& x : model.simulated)
        x = x * problem.positionScale + problem.positionShift;
    model.nuisance = nuisanceInChannelUnits(problem, point->x0, point->v0, point->offset);
    model.record = std::move(static_cast<OutputErrorProblem&>(problem));
    const bool usable = model.simulated.size() == record.position.size() && allFinite(model.simulated) &&
                        model.nuisances.allFinite() && model.parameters.allFinite() &&
                        model.residual.allFinite();
    return usable ? std::optional(std::move(model)) : std::nullopt;
}

} // namespace gripscope
