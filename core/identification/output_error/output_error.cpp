// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error.h"

#include "core/base/words.h"
#include "core/identification/model/discretization.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/identification/output_error/output_error_search.h"
#include "core/math/fit.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// The noise at which the search for it starts, as a share of the position's size.
constexpr double firstNoiseShare = 0.1;
/// Share of the position's size below which noise is rounding.
constexpr double noiseRounding = 1e-12;
/// Of the logarithm of the noise: a thousandth of it moves nothing that counts.
constexpr double noiseTolerance = 1e-3, longestNoiseStep = 4;
constexpr int noiseRounds = 20;

Estimate failedOutputError(EstimateStatus status, const Finding& message)
{
    return statusOnly(Estimator::OutputError, status, message);
}

/// The force with the values found for the lost samples.
std::vector<double> completedForce(const OutputErrorProblem& problem, const ScaledNuisance& nuisance,
                                   const std::vector<double>& force)
{
    std::vector<double> completed = force;
    for (std::size_t i = 0; i < problem.lost.size(); ++i)
        completed[problem.lost[i]] = nuisance.lostForces[i] * problem.forceScale;
    return completed;
}

/// Model output and residuals; nothing was measured at the lost samples, so there the residual is zero.
void simulateSolution(const OutputErrorProblem& problem, const std::vector<double>& completedForce,
                      const std::vector<double>& position, const OutputErrorOptions& options,
                      Estimate& estimate)
{
    const SimulationOptions simulation{options.sampleTime_s,
                                       options.hold,
                                       options.lag_s,
                                       estimate.nuisance.x0.value_or(0),
                                       estimate.nuisance.v0.value_or(0),
                                       estimate.nuisance.offset.value_or(0)};
    estimate.simulated = simulate(*estimate.parameters, completedForce, simulation);
    estimate.residual.resize(position.size());
    for (std::size_t i = 0; i < position.size(); ++i)
        estimate.residual[i] = position[i] - estimate.simulated[i];
    for (const std::size_t lost : problem.lost)
        estimate.residual[lost] = 0;
}

/// Those of the rows used that were measured.
std::vector<double> measuredOnly(const OutputErrorProblem& problem, const std::vector<double>& values)
{
    std::vector<double> measured;
    measured.reserve(static_cast<std::size_t>(problem.rows()));
    auto lost = problem.lost.begin();
    const auto end = static_cast<std::size_t>(problem.endRow());
    for (auto t = static_cast<std::size_t>(problem.firstRow()); t < end; ++t) {
        while (lost != problem.lost.end() && *lost < t)
            ++lost;
        if (lost == problem.lost.end() || *lost != t)
            measured.push_back(values[t]);
    }
    return measured;
}

/// Fits, residuals and their tests at the solution.
void describeResiduals(const OutputErrorProblem& problem, const SearchResult& search,
                       const std::vector<double>& force, const std::vector<double>& position,
                       const OutputErrorOptions& options, Estimate& estimate)
{
    const std::vector<double> completed = completedForce(problem, search.linear.nuisance, force);
    for (const std::size_t lost : problem.lost)
        estimate.lostForces.push_back(completed[lost]);
    simulateSolution(problem, completed, position, options, estimate);
    const std::vector<double> residual = measuredOnly(problem, estimate.residual);
    estimate.fit.simulationPercent =
        fitPercent(measuredOnly(problem, position), measuredOnly(problem, estimate.simulated));
    estimate.fit.predictionPercent = estimate.fit.simulationPercent;
    for (const double e : residual)
        estimate.residuals.sse += e * e;
    if (!problem.lost.empty())
        estimate.residuals.sse = search.linear.cost * problem.positionScale * problem.positionScale;
    estimate.residuals.sse = std::min(estimate.residuals.sse, std::numeric_limits<double>::max());
    estimate.residuals.degreesOfFreedom =
        static_cast<double>(problem.terms() - 3 - search.linear.nuisanceRank);
    if (options.residuals == ResidualDepth::Sums)
        return;
    const OutputErrorResiduals tests =
        testOutputError(problem, search.theta, search.linear.nuisance, options.residuals);
    ResidualSummary summary = tests.summary;
    summary.sse = estimate.residuals.sse;
    summary.degreesOfFreedom = estimate.residuals.degreesOfFreedom;
    estimate.residuals = summary;
    estimate.noise = tests.noise;
    if (tests.logCovariance) {
        const Eigen::Vector3d p = estimate.parameters->vector();
        const Eigen::Matrix3d covariance = p.asDiagonal() * *tests.logCovariance * p.asDiagonal();
        if (covariance.allFinite())
            estimate.covariance = covariance;
    }
}

/// s^2 (J'J)^-1 in channel units: d theta_i = d p_i / p_i.
std::optional<Eigen::Matrix3d> covarianceOf(const SearchResult& search,
                                            const MassDampingStiffness& parameters, double degreesOfFreedom)
{
    const Eigen::Matrix3d inverse = search.linear.triangle.inverse();
    const double variance = search.linear.cost / degreesOfFreedom;
    const Eigen::Vector3d p = parameters.vector();
    const Eigen::Matrix3d covariance =
        variance * (p.asDiagonal() * inverse * inverse.transpose() * p.asDiagonal());
    return covariance.allFinite() ? std::optional(covariance) : std::nullopt;
}

/// From the start given, or from those found in the data; where these are poor or lead nowhere, from a grid
/// as well.
std::optional<SearchResult> findSolution(const OutputErrorProblem& problem, const OutputErrorOptions& options)
{
    MultiStart<SearchResult> searches;
    const auto from = [&](const Eigen::Vector3d& start) {
        return start.allFinite()
                   ? std::optional(searchOutputError(problem, start, options.maxIterations, options.arrived))
                   : std::nullopt;
    };
    if (options.start) {
        searches.run(std::array{problem.toTheta(*options.start)}, from);
        return searches.best();
    }
    const OutputErrorStarts starts = outputErrorStarts(problem);
    searches.run(starts.bestFirst, from);
    if (!starts.trusted || !searches.isGood())
        searches.run(outputErrorGrid(problem), from);
    return searches.best();
}

/// The noise that the rows of the lost forces are weighed by is the noise that the residuals then have: a
/// fixed point, found by the secant rule in its logarithm, from one search to the next.
std::optional<SearchResult> findSolutionAndNoise(OutputErrorProblem& problem,
                                                 const OutputErrorOptions& options)
{
    if (problem.lost.empty())
        return findSolution(problem, options);
    const double size = std::sqrt(squaredSize(problem) / static_cast<double>(problem.position.size()));
    problem.noiseDeviation = firstNoiseShare * size;
    std::optional<SearchResult> found = findSolution(problem, options);
    double before = 0;
    double changeBefore = 0;
    for (int round = 0; round < noiseRounds && found && found->isSettled(); ++round) {
        const auto degreesOfFreedom = static_cast<double>(problem.terms() - 3 - found->linear.nuisanceRank);
        const double noise = std::max(std::sqrt(found->linear.cost / degreesOfFreedom), noiseRounding * size);
        const double here = std::log(problem.noiseDeviation);
        const double change = std::log(noise) - here;
        if (std::abs(change) < noiseTolerance)
            break;
        const double slope = round > 0 ? (change - changeBefore) / (here - before) : 0;
        const double step =
            slope < 0 ? std::clamp(-change / slope, -longestNoiseStep, longestNoiseStep) : change;
        before = here;
        changeBefore = change;
        problem.noiseDeviation = std::exp(std::max(here + step, std::log(noiseRounding * size)));
        if (std::log(problem.noiseDeviation) == here)
            break;
        found = searchOutputError(problem, found->theta, options.maxIterations, options.arrived);
    }
    return found;
}

} // namespace

Estimate estimateOutputError(const std::vector<double>& force, const std::vector<double>& position,
                             const OutputErrorOptions& options)
{
    const int parameterCount = 3 + (options.freeInitialState ? 2 : 0) + (options.freeOffset ? 1 : 0);
    if (static_cast<int>(std::min<std::size_t>(force.size(), 100)) <= parameterCount)
        return failedOutputError(
            EstimateStatus::TooFewSamples,
            Words::say("there are fewer samples than output error has unknowns; record for longer"));
    OutputErrorProblem problem = makeOutputErrorProblem(force, position, options);
    if (problem.rows() <= parameterCount)
        return failedOutputError(EstimateStatus::TooFewSamples,
                                 Words::say("the lag between the channels leaves too few samples"));
    if (problem.measuredRows() <= std::max<std::ptrdiff_t>(parameterCount, problem.rows() / 2))
        return failedOutputError(
            EstimateStatus::TooFewSamples,
            Words::say("more than half of the samples are lost; check the connection and record again"));
    if (isConstant(problem.position))
        return failedOutputError(EstimateStatus::NotIdentifiable, Words::say(constantPosition));

    const std::optional<SearchResult> found = findSolutionAndNoise(problem, options);
    if (!found)
        return failedOutputError(EstimateStatus::NotIdentifiable, isConstant(problem.force)
                                                                      ? Words::say(constantForce)
                                                                      : Words::say(noAnswer));
    const SearchResult& search = *found;
    Estimate estimate = failedOutputError(EstimateStatus::NotIdentifiable, Finding());
    estimate.iterations = search.iterations;
    if (!search.isDetermined()) {
        estimate.message = Words::say(isConstant(problem.force) ? constantForce : poorForce);
        return estimate;
    }
    if (search.outcome == SearchOutcome::Boundary) {
        estimate.message = boundaryMessage(search.boundaryIndex, search.boundaryAtZero);
        if (search.boundaryAtZero) // m, b and k come first
            estimate.notFromZero = static_cast<MotionParameter>(search.boundaryIndex);
        return estimate;
    }
    const MassDampingStiffness parameters = problem.toChannelUnits(search.theta);
    const Eigen::Vector3d p = parameters.vector();
    if (!p.allFinite() || !(p.minCoeff() > 0)) {
        estimate.message = Words::say("m, b or k is outside the range of numbers");
        return estimate;
    }
    estimate.parameters = parameters;
    const ScaledNuisance& solution = search.linear.nuisance;
    estimate.nuisance = nuisanceInChannelUnits(problem, solution.x0, solution.v0, solution.offset);
    estimate.status =
        search.outcome == SearchOutcome::Converged ? EstimateStatus::Converged : EstimateStatus::NotConverged;
    estimate.message = search.outcome == SearchOutcome::Converged ? Words::say("converged")
                                                                  : Words::say("the search did not settle");
    describeResiduals(problem, search, force, position, options, estimate);
    if (!estimate.covariance)
        estimate.covariance = covarianceOf(search, parameters, estimate.residuals.degreesOfFreedom);
    return estimate;
}

bool explainsMore(const Estimate& estimate, const Estimate& other)
{
    return estimate.residuals.sse * static_cast<double>(other.residual.size()) <
           other.residuals.sse * static_cast<double>(estimate.residual.size());
}

Estimate estimateBeside(const Estimate& known, const std::vector<double>& force,
                        const std::vector<double>& position, OutputErrorOptions options)
{
    options.residuals = ResidualDepth::Sums;
    Estimate found = estimateOutputError(force, position, options);
    if (!found.parameters || !explainsMore(found, known))
        return found;
    options.residuals = ResidualDepth::Noise;
    options.start = found.parameters;
    return estimateOutputError(force, position, options);
}

} // namespace gripscope
