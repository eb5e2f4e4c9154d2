// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/motion_model.h"
#include "core/identification/output_error/output_error.h"
#include "core/identification/validation/validation_contrast.h"
#include "core/math/fit.h"
#include "core/math/least_squares.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr int mostRounds = 30, mostHalvings = 20;
/// Share of the sum of squares that a further round must be worth.
constexpr double worthwhile = 1e-12;

/// The step of the start and the offset that fits the residuals best, and none of the parameters.
Eigen::VectorXd nuisanceStep(const MotionProblem& problem, const MotionRows& rows)
{
    const Eigen::Index free = problem.startUnknowns();
    const Eigen::Map<const Eigen::VectorXd> residual(rows.residuals.data(),
                                                     static_cast<Eigen::Index>(rows.residuals.size()));
    const Eigen::MatrixXd columns = rows.sensitivities.leftCols(free);
    const Eigen::VectorXd scales = columns.colwise().norm().transpose().cwiseMax(1e-300).cwiseInverse();
    const Eigen::MatrixXd normal =
        scales.asDiagonal() * (columns.transpose() * columns) * scales.asDiagonal();
    const Eigen::VectorXd right = scales.asDiagonal() * (columns.transpose() * residual);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(problem.unknowns());
    step.head(free) = scales.asDiagonal() * solvePivoted(normal, right).solution.col(0);
    return step;
}

/// Gauss-Newton in start and offset; one round where the motion is linear, since they enter linearly.
std::optional<MotionPoint> fitNuisances(const MotionProblem& problem, MotionPoint point)
{
    std::optional<MotionCost> at = costAt(problem, point);
    for (int round = 0; at && round < mostRounds; ++round) {
        const std::optional<MotionRows> rows = motionRows(problem, point);
        if (!rows)
            return std::nullopt;
        Eigen::VectorXd step = nuisanceStep(problem, *rows);
        if (!step.allFinite())
            return std::nullopt;
        const double before = at->cost;
        for (int halving = 0; halving < mostHalvings; ++halving, step /= 2) {
            const MotionPoint trial = point.moved(problem, step);
            const std::optional<MotionCost> there = costAt(problem, trial);
            if (there && there->cost < at->cost) {
                point = trial;
                at = there;
                break;
            }
        }
        if (!(before - at->cost > worthwhile * before))
            break;
    }
    return at ? std::optional(point) : std::nullopt;
}

/// From where mass, spring and damper alone would start, which is near enough for more.
std::optional<MotionPoint> fittedPoint(const MotionProblem& problem, const MotionValues& values)
{
    MotionProblem linear = problem;
    linear.terms = {};
    MotionPoint point;
    point.values = inProblemUnits(linear, values);
    std::optional<MotionPoint> fitted = fitNuisances(linear, point);
    if (!fitted || problem.terms == linear.terms)
        return fitted;
    fitted->values = inProblemUnits(problem, values);
    return fitNuisances(problem, *fitted);
}

} // namespace

std::optional<GivenModel> applyGivenModel(const MotionTerms& terms, const MotionValues& values,
                                          const PreparedRecord& record, ForceHold hold)
{
    ContinuousTimeOptions options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = hold;
    options.lag_s = record.forceLag_s;
    if (record.force.empty() || record.force.size() != record.position.size())
        return std::nullopt;
    MotionProblem problem{makeOutputErrorProblem(record.force, record.position, options), terms};
    if (problem.rows() <= problem.unknowns())
        return std::nullopt;
    const std::optional<MotionPoint> point = fittedPoint(problem, values);
    const std::optional<MotionRows> rows = point ? motionRows(problem, *point) : std::nullopt;
    if (!rows)
        return std::nullopt;

    const Eigen::Index free = problem.startUnknowns();
    GivenModel model;
    model.nuisances = rows->sensitivities.leftCols(free).transpose();
    model.parameters = rows->sensitivities.rightCols(problem.unknowns() - free).transpose();
    const std::vector<MotionParameter> parameters = terms.parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (!isPositive(parameters[i]))
            model.parameters.row(static_cast<Eigen::Index>(i)) /= problem.unitOf(parameters[i]);
    model.residual = Eigen::Map<const Eigen::RowVectorXd>(rows->residuals.data(),
                                                          static_cast<Eigen::Index>(rows->residuals.size()));
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
