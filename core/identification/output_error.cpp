// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error.h"

#include "core/identification/discretization.h"
#include "core/identification/fit.h"
#include "core/identification/output_error_residuals.h"
#include "core/identification/output_error_search.h"
#include "core/identification/output_error_start.h"
#include "core/identification/tall_qr.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// Above this condition number of the scaled sensitivities, rounding decides what m, b and k are.
constexpr double largestCondition = 1e8;

constexpr const char* constantForce = "a constant force does not determine m, b and k together with a free "
                                      "start and offset; squeeze with a force that "
                                      "varies, for instance a pseudo-random binary sequence";
constexpr const char* noAnswer =
    "the position does not answer the force; check the grip and which column is which";

Estimate failed(EstimateStatus status, const char* message)
{
    Estimate estimate;
    estimate.estimator = Estimator::OutputError;
    estimate.status = status;
    estimate.message = message;
    return estimate;
}

bool isConstant(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
}

OutputErrorProblem scaledProblem(const std::vector<double>& force, const std::vector<double>& position,
                                 const OutputErrorOptions& options)
{
    OutputErrorProblem problem;
    problem.hold = options.hold;
    problem.lag = LagAlignment(options.lag_s, options.sampleTime_s);
    problem.freeInitialState = options.freeInitialState;
    problem.freeOffset = options.freeOffset;
    problem.sampleTime_s = options.sampleTime_s;
    problem.forceScale = powerOfTwoScale(force);
    problem.force.reserve(force.size());
    for (const double value : force)
        problem.force.push_back(value / problem.forceScale);
    problem.position = position;
    if (options.freeOffset) {
        // A free offset takes any constant up; without the largest part of it less is lost to rounding.
        problem.positionShift = position.front();
        for (double& value : problem.position)
            value -= problem.positionShift;
    }
    problem.positionScale = powerOfTwoScale(problem.position);
    for (double& value : problem.position)
        value /= problem.positionScale;
    return problem;
}

Nuisance nuisanceInChannelUnits(const OutputErrorProblem& problem, const ScaledNuisance& scaled)
{
    Nuisance nuisance;
    if (problem.freeInitialState) {
        nuisance.x0 = scaled.x0 * problem.positionScale;
        nuisance.v0 = scaled.v0 * problem.positionScale / problem.sampleTime_s;
    }
    if (problem.freeOffset)
        nuisance.offset = scaled.offset * problem.positionScale + problem.positionShift;
    return nuisance;
}

/// Model output, residuals, fits and their tests at the solution.
void describeResiduals(const OutputErrorProblem& problem, const SearchResult& search,
                       const std::vector<double>& force, const std::vector<double>& position,
                       const OutputErrorOptions& options, Estimate& estimate)
{
    const SimulationOptions simulation{options.sampleTime_s,
                                       options.hold,
                                       options.lag_s,
                                       estimate.nuisance.x0.value_or(0),
                                       estimate.nuisance.v0.value_or(0),
                                       estimate.nuisance.offset.value_or(0)};
    estimate.simulated = simulate(*estimate.parameters, force, simulation);
    estimate.residual.resize(position.size());
    for (std::size_t i = 0; i < position.size(); ++i)
        estimate.residual[i] = position[i] - estimate.simulated[i];
    const auto first = static_cast<std::size_t>(problem.firstRow());
    const auto rows = static_cast<std::size_t>(problem.rows());
    const std::span<const double> used = std::span(position).subspan(first, rows);
    estimate.fit.simulationPercent =
        fitPercent(used, std::span<const double>(estimate.simulated).subspan(first, rows));
    estimate.fit.predictionPercent = estimate.fit.simulationPercent;
    for (const double e : std::span<const double>(estimate.residual).subspan(first, rows))
        estimate.residuals.sse += e * e;
    estimate.residuals.sse = std::min(estimate.residuals.sse, std::numeric_limits<double>::max());
    estimate.residuals.degreesOfFreedom =
        static_cast<double>(problem.rows() - 3 - search.response.nuisanceRank);
    const OutputErrorResiduals tests = testOutputError(problem, search.theta, search.response.nuisance);
    estimate.residuals.whitenessP = tests.whitenessP;
    estimate.residuals.inputIndependenceP = tests.inputIndependenceP;
    estimate.residuals.errorInflation = tests.errorInflation;
}

/// s^2 (J'J)^-1 in channel units: d theta_i = d p_i / p_i.
std::optional<Eigen::Matrix3d> covarianceOf(const SearchResult& search,
                                            const MassDampingStiffness& parameters, double degreesOfFreedom)
{
    const Eigen::Matrix3d inverse = search.triangle.inverse();
    const double variance = search.response.cost / degreesOfFreedom;
    const Eigen::Vector3d p = parameters.vector();
    const Eigen::Matrix3d covariance =
        variance * (p.asDiagonal() * inverse * inverse.transpose() * p.asDiagonal());
    return covariance.allFinite() ? std::optional(covariance) : std::nullopt;
}

/// What the search found is more than rounding.
bool isDetermined(const SearchResult& search)
{
    return search.response.finite && search.response.ownShare >= smallestOwnShare &&
           scaledConditionNumber(search.triangle) <= largestCondition;
}

/// The search ended at an optimum and the data determines it.
bool isSettled(const SearchResult& search)
{
    return search.outcome == SearchOutcome::Converged && isDetermined(search);
}

/// Runs from one start after the other; keeps the best optimum, or else the first answer.
class Tries {
public:
    Tries(const OutputErrorProblem& problem, int maxIterations)
        : m_problem(problem), m_maxIterations(maxIterations)
    {
    }

    void run(const std::vector<Eigen::Vector3d>& starts)
    {
        for (const Eigen::Vector3d& start : starts) {
            if (!start.allFinite())
                continue;
            const SearchResult search = searchOutputError(m_problem, start, m_maxIterations);
            const bool better =
                isSettled(search) && (!settled() || search.response.cost < m_best->response.cost);
            if (!m_best || better)
                m_best = search;
            if (settled())
                return;
        }
    }
    [[nodiscard]] bool settled() const { return m_best && isSettled(*m_best); }
    [[nodiscard]] std::optional<SearchResult> best() const { return m_best; }

private:
    const OutputErrorProblem& m_problem;
    int m_maxIterations;
    std::optional<SearchResult> m_best;
};

/// From the start given, or from those found in the data; where these are poor or lead nowhere, from a grid
/// as well.
std::optional<SearchResult> findSolution(const OutputErrorProblem& problem, const OutputErrorOptions& options)
{
    Tries tries(problem, options.maxIterations);
    if (options.start) {
        tries.run({problem.toTheta(*options.start)});
        return tries.best();
    }
    const OutputErrorStarts starts = outputErrorStarts(problem);
    tries.run(starts.bestFirst);
    if (!starts.trusted || !tries.settled())
        tries.run(outputErrorGrid(problem));
    return tries.best();
}

const char* boundaryMessage(const SearchResult& search)
{
    static constexpr std::array<const char*, 3> toZero{
        "the mass cannot be told from zero; excite faster, or sample faster",
        "the damping cannot be told from zero; squeeze longer or with more force",
        "the stiffness cannot be told from zero; squeeze longer"};
    static constexpr std::array<const char*, 3> toInfinity{
        "no finite mass explains the position; check the grip and the sensor",
        "no finite damping explains the position; check the grip and the sensor",
        "no finite stiffness explains the position; check the grip and the sensor"};
    const auto i = static_cast<std::size_t>(search.boundaryIndex);
    return search.boundaryAtZero ? toZero[i] : toInfinity[i];
}

} // namespace

Estimate estimateOutputError(const std::vector<double>& force, const std::vector<double>& position,
                             const OutputErrorOptions& options)
{
    const int parameterCount = 3 + (options.freeInitialState ? 2 : 0) + (options.freeOffset ? 1 : 0);
    if (static_cast<int>(std::min<std::size_t>(force.size(), 100)) <= parameterCount)
        return failed(EstimateStatus::TooFewSamples,
                      "there are fewer samples than output error has unknowns; record for longer");
    const OutputErrorProblem problem = scaledProblem(force, position, options);
    if (problem.rows() <= parameterCount)
        return failed(EstimateStatus::TooFewSamples, "the lag between the channels leaves too few samples");
    if (isConstant(position))
        return failed(
            EstimateStatus::NotIdentifiable,
            "the position does not change; check that the fingers hold the object and that the sensor works");

    const std::optional<SearchResult> found = findSolution(problem, options);
    if (!found)
        return failed(EstimateStatus::NotIdentifiable, isConstant(force) ? constantForce : noAnswer);
    const SearchResult& search = *found;
    Estimate estimate = failed(EstimateStatus::NotIdentifiable, "");
    estimate.iterations = search.iterations;
    if (!isDetermined(search)) {
        estimate.message = isConstant(force)
                               ? constantForce
                               : "this force does not determine m, b and k; squeeze with a richer one";
        return estimate;
    }
    if (search.outcome == SearchOutcome::Boundary) {
        estimate.message = boundaryMessage(search);
        return estimate;
    }
    const MassDampingStiffness parameters = problem.toChannelUnits(search.theta);
    const Eigen::Vector3d p = parameters.vector();
    if (!p.allFinite() || !(p.minCoeff() > 0)) {
        estimate.message = "m, b or k is outside the range of numbers";
        return estimate;
    }
    estimate.parameters = parameters;
    estimate.nuisance = nuisanceInChannelUnits(problem, search.response.nuisance);
    estimate.status =
        search.outcome == SearchOutcome::Converged ? EstimateStatus::Converged : EstimateStatus::NotConverged;
    estimate.message = search.outcome == SearchOutcome::Converged ? "converged" : "the search did not settle";
    describeResiduals(problem, search, force, position, options, estimate);
    estimate.covariance = covarianceOf(search, parameters, estimate.residuals.degreesOfFreedom);
    return estimate;
}

std::optional<double> sseUnderOtherHold(const std::vector<double>& force, const std::vector<double>& position,
                                        const OutputErrorOptions& options, const MassDampingStiffness& found)
{
    OutputErrorOptions other = options;
    other.hold = options.hold == ForceHold::Zero ? ForceHold::First : ForceHold::Zero;
    const OutputErrorProblem problem = scaledProblem(force, position, other);
    // A few iterations will do: the two optima are close, and a cost that is a little high is on the safe
    // side.
    constexpr int iterations = 10;
    const SearchResult search = searchOutputError(problem, problem.toTheta(found), iterations);
    const double sse = search.response.cost * problem.positionScale * problem.positionScale;
    return search.response.finite && std::isfinite(sse) ? std::optional(sse) : std::nullopt;
}

} // namespace gripscope
