// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing/duffing.h"

#include "core/base/words.h"
#include "core/identification/duffing/duffing_model.h"
#include "core/identification/model/discretization.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/completed_record.h"
#include "core/identification/output_error/output_error.h"
#include "core/math/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// Of longer records a first part is enough to find the way.
constexpr std::size_t firstPart = 8000;
/// Largest shift of a parameter by the integration, in standard errors; and the integration's error beside
/// the positions where there is no noise.
constexpr double toleratedShift = 0.01, toleratedError = 1e-9;
constexpr int mostFinalSubsteps = 256;

Estimate failedDuffing(EstimateStatus status, const Finding& message)
{
    return statusOnly(Estimator::Duffing, status, message);
}

DuffingProblem scaledProblem(const std::vector<double>& force, const std::vector<double>& position,
                             const DuffingOptions& options)
{
    return {makeOutputErrorProblem(force, position, options), 1};
}

DuffingPoint pointFrom(const DuffingProblem& problem, const MassDampingStiffness& parameters, double k3,
                       const Nuisance& nuisance)
{
    DuffingPoint point;
    point.theta = problem.toTheta(parameters);
    point.cubic = k3 / cubicUnit(problem);
    point.x0 = nuisance.x0.value_or(0) / problem.positionScale;
    point.v0 = nuisance.v0.value_or(0) * problem.sampleTime_s / problem.positionScale;
    if (nuisance.offset)
        point.offset = (*nuisance.offset - problem.positionShift) / problem.positionScale;
    return point;
}

/// The start given, else the linear spring that fits best.
std::vector<DuffingPoint> knownStarts(const DuffingProblem& problem, const std::vector<double>& force,
                                      const std::vector<double>& position, const DuffingOptions& options)
{
    if (options.start)
        return {pointFrom(problem, *options.start, options.startCubic, {})};
    OutputErrorOptions linear{options};
    linear.residuals = ResidualDepth::Sums;
    const Estimate estimate = estimateOutputError(force, position, linear);
    if (!estimate.parameters)
        return {};
    return {pointFrom(problem, *estimate.parameters, 0, estimate.nuisance)};
}

double largestMotion(const DuffingProblem& problem, const DuffingPoint& point)
{
    double largest = 0;
    for (const double y : problem.position)
        largest = std::max(largest, std::abs(y - point.offset));
    return largest;
}

/// From one start after the other until one leads to an optimum that explains the position; the best of them.
std::optional<DuffingSearchResult> searchFrom(DuffingProblem& problem,
                                              const std::vector<DuffingPoint>& starts, int maxIterations)
{
    MultiStart<DuffingSearchResult> searches(poorShare * positionEnergy(problem));
    searches.run(starts, [&](const DuffingPoint& start) {
        problem.substeps = suitableSubsteps(start, largestMotion(problem, start));
        return std::optional(searchDuffing(problem, start, maxIterations));
    });
    const std::optional<DuffingSearchResult>& best = searches.best();
    if (best)
        problem.substeps = suitableSubsteps(best->point, largestMotion(problem, best->point));
    return best;
}

/// Root-mean-square change of the positions when the steps are halved; infinite when either leaves all
/// bounds.
double integrationError(DuffingProblem& problem, const DuffingPoint& point)
{
    const std::vector<double> coarse = positionsAt(problem, point);
    problem.substeps *= 2;
    const std::vector<double> fine = positionsAt(problem, point);
    problem.substeps /= 2;
    if (coarse.empty() || fine.empty())
        return std::numeric_limits<double>::infinity();
    double squares = 0;
    for (std::size_t i = 0; i < coarse.size(); ++i)
        squares += (coarse[i] - fine[i]) * (coarse[i] - fine[i]);
    return std::sqrt(squares / static_cast<double>(coarse.size()));
}

/// Shortens the steps and searches on until the integration is as exact as the data asks for.
void settleIntegration(DuffingProblem& problem, DuffingSearchResult& search, int maxIterations)
{
    const auto count = static_cast<double>(problem.measuredRows());
    const double size = std::sqrt(positionEnergy(problem) / count);
    while (search.linear.finite && problem.substeps < mostFinalSubsteps) {
        const double noise = std::sqrt(search.linear.cost / search.degreesOfFreedom(problem));
        const double tolerated = std::max(toleratedShift * noise / std::sqrt(count), toleratedError * size);
        const double error = integrationError(problem, search.point);
        if (error <= tolerated)
            return;
        // The error falls with the fourth power of the step.
        const double factor = std::clamp(std::ceil(1.1 * std::pow(error / tolerated, 0.25)), 2.0, 16.0);
        problem.substeps = std::min(static_cast<int>(factor) * problem.substeps, mostFinalSubsteps);
        const int before = search.iterations;
        search = searchDuffing(problem, search.point, maxIterations);
        search.iterations += before;
    }
}

/// The search on the first part of a long record, whose answer is where that on all of it begins.
std::vector<DuffingPoint> startsFor(DuffingProblem& problem, const std::vector<double>& force,
                                    const std::vector<double>& position, const DuffingOptions& options)
{
    if (force.size() > 2 * firstPart && std::abs(problem.lag.samples) < std::ptrdiff_t{firstPart} / 2) {
        const std::vector<double> someForce(force.begin(), force.begin() + firstPart);
        const std::vector<double> somePosition(position.begin(), position.begin() + firstPart);
        if (!isConstant(somePosition)) {
            DuffingProblem part = scaledProblem(someForce, somePosition, options);
            // In the whole record's units.
            for (double& f : part.force)
                f *= part.forceScale / problem.forceScale;
            for (double& y : part.position)
                y *= part.positionScale / problem.positionScale;
            part.forceScale = problem.forceScale;
            part.positionScale = problem.positionScale;
            const auto found =
                searchFrom(part, duffingStarts(part, knownStarts(part, someForce, somePosition, options)),
                           options.maxIterations);
            if (found && found->isSettled() && found->cost() <= poorShare * positionEnergy(part))
                return {found->point};
        }
    }
    return duffingStarts(problem, knownStarts(problem, force, position, options));
}

/// s^2 (J'J)^-1 in channel units: d theta_i = d p_i / p_i.
std::optional<Eigen::Matrix4d> covarianceOf(const DuffingSearchResult& search, const Eigen::Vector4d& units,
                                            double degreesOfFreedom)
{
    const Eigen::Matrix4d inverse = inverseOfTriangle(triangleOf(search.linear.projected));
    const Eigen::Matrix4d root = units.asDiagonal() * inverse;
    const Eigen::Matrix4d covariance = search.linear.cost / degreesOfFreedom * (root * root.transpose());
    return covariance.allFinite() ? std::optional(covariance) : std::nullopt;
}

/// Model output, residuals, fits and their tests at the solution.
void describe(const DuffingProblem& problem, const DuffingSearchResult& search,
              const std::vector<double>& position, Estimate& estimate)
{
    estimate.simulated = positionsAt(problem, search.point);
    estimate.simulated.resize(position.size());
    for (double& x : estimate.simulated)
        x = x * problem.positionScale + problem.positionShift;
    estimate.residuals.degreesOfFreedom = search.degreesOfFreedom(problem);
    const DuffingRows rows = duffingRows(problem, search.point);
    describeResiduals(problem, position, rows.sensitivities, rows.residuals, estimate);
}

Finding duffingBoundaryMessage(const DuffingSearchResult& search)
{
    static constexpr std::array<const char*, 3> toZero{
        QT_TRANSLATE_NOOP(
            "Words",
            "the mass cannot be told from zero beside a cubic spring; excite faster, or sample faster"),
        QT_TRANSLATE_NOOP(
            "Words",
            "the damping cannot be told from zero beside a cubic spring; squeeze longer or with more force"),
        QT_TRANSLATE_NOOP("Words", "the linear stiffness cannot be told from zero beside a cubic spring; "
                                   "squeeze longer, and gently as "
                                   "well as hard")};
    return search.boundaryAtZero ? Words::say(toZero[static_cast<std::size_t>(search.boundaryIndex)])
                                 : boundaryMessage(search.boundaryIndex, false);
}

/// What keeps the estimator from starting, or nothing.
std::optional<Estimate> obstacle(const std::vector<double>& force, const std::vector<double>& position,
                                 const DuffingProblem& problem)
{
    if (problem.measuredRows() <= problem.unknowns())
        return failedDuffing(EstimateStatus::TooFewSamples,
                             Words::say("the lag between the channels leaves too few samples"));
    if (isConstant(position))
        return failedDuffing(EstimateStatus::NotIdentifiable, Words::say(constantPosition));
    if (isConstant(force) && problem.freeInitialState)
        return failedDuffing(
            EstimateStatus::NotIdentifiable,
            Words::say(
                "a constant force does not determine m, b, k and k3 together with a free start; squeeze "
                "with a force that varies, for instance a pseudo-random binary sequence"));
    return std::nullopt;
}

/// The solution in channel units; without parameters when they are no numbers there.
Estimate inChannelUnits(const DuffingProblem& problem, const DuffingSearchResult& search,
                        const std::vector<double>& position)
{
    const MassDampingStiffness parameters = problem.toChannelUnits(search.point.theta);
    const Eigen::Vector3d p = parameters.vector();
    const double k3 = search.point.cubic * cubicUnit(problem);
    const auto covariance =
        covarianceOf(search, {p(0), p(1), p(2), cubicUnit(problem)}, search.degreesOfFreedom(problem));
    if (!p.allFinite() || !(p.minCoeff() > 0) || !std::isfinite(k3) || !covariance)
        return failedDuffing(EstimateStatus::NotIdentifiable,
                             Words::say("m, b, k, k3 or their errors are outside the range of numbers"));
    const bool converged = search.outcome == SearchOutcome::Converged;
    Estimate estimate =
        converged ? failedDuffing(EstimateStatus::Converged, Words::say("converged"))
                  : failedDuffing(EstimateStatus::NotConverged, Words::say("the search did not settle"));
    estimate.parameters = parameters;
    estimate.covariance = covariance->topLeftCorner<3, 3>();
    estimate.cubic = CubicSpring{k3, *covariance};
    estimate.nuisance =
        nuisanceInChannelUnits(problem, search.point.x0, search.point.v0, search.point.offset);
    describe(problem, search, position, estimate);
    return estimate;
}

void widen(Estimate& estimate, double factor)
{
    if (!estimate.cubic || !estimate.covariance)
        return;
    *estimate.covariance *= factor * factor;
    estimate.cubic->covariance *= factor * factor;
}

/// With every force known, or completed.
Estimate estimateCompleted(const CompletedRecord& completed, const DuffingOptions& options)
{
    DuffingProblem problem{completedProblem(completed, options), 1};
    if (const std::optional<Estimate> stop = obstacle(completed.force, completed.position, problem))
        return *stop;
    DuffingOptions known = options;
    known.lost.clear();
    const std::vector<DuffingPoint> starts = startsFor(problem, completed.force, completed.position, known);
    std::optional<DuffingSearchResult> search = searchFrom(problem, starts, options.maxIterations);
    if (!search || search->outcome == SearchOutcome::Lost)
        return failedDuffing(EstimateStatus::NotIdentifiable, Words::say(noAnswer));
    if (search->isSettled())
        settleIntegration(problem, *search, options.maxIterations);
    Estimate estimate = failedDuffing(EstimateStatus::NotIdentifiable, Finding());
    if (search->outcome == SearchOutcome::Boundary)
        estimate.message = duffingBoundaryMessage(*search);
    else if (!search->isDetermined())
        estimate.message =
            Words::say("this force does not determine m, b, k and k3; squeeze with a richer one");
    else
        estimate = inChannelUnits(problem, *search, completed.position);
    estimate.iterations = search->iterations;
    widen(estimate, completed.errorFactor);
    return estimate;
}

/// The lost forces once more, from positions without what the cubic spring in `found` adds to those of a
/// linear one.
CompletedRecord completedAgain(const CompletedRecord& completed, const Estimate& found,
                               const DuffingOptions& options)
{
    const Nuisance& n = found.nuisance;
    const std::vector<double> linear = simulate(*found.parameters, completed.force,
                                                {options.sampleTime_s, options.hold, options.lag_s,
                                                 n.x0.value_or(0), n.v0.value_or(0), n.offset.value_or(0)});
    std::vector<double> position = completed.position;
    for (std::size_t i = 0; i < position.size(); ++i)
        position[i] -= found.simulated[i] - linear[i];
    ContinuousTimeOptions asked = options;
    asked.start = found.parameters;
    CompletedRecord again = completedRecord(completed.force, position, asked);
    again.position = completed.position;
    return again;
}

} // namespace

Estimate estimateDuffing(const std::vector<double>& force, const std::vector<double>& position,
                         const DuffingOptions& options)
{
    if (force.size() != position.size())
        return failedDuffing(EstimateStatus::NotApplicable,
                             Words::say("force and position have different lengths"));
    const std::size_t unknowns = 4 + (options.freeInitialState ? 2 : 0) + (options.freeOffset ? 1 : 0);
    if (force.size() <= unknowns)
        return failedDuffing(
            EstimateStatus::TooFewSamples,
            Words::say("there are fewer samples than the cubic spring has unknowns; record for longer"));
    const CompletedRecord completed = completedRecord(force, position, options);
    if (!options.lost.empty() && !completed.outputError.parameters)
        return failedDuffing(completed.outputError.status, completed.outputError.message);
    Estimate estimate = estimateCompleted(completed, options);
    if (completed.lost.empty() || estimate.status != EstimateStatus::Converged)
        return estimate;
    const CompletedRecord again = completedAgain(completed, estimate, options);
    if (!again.outputError.parameters)
        return estimate;
    DuffingOptions near = options;
    near.start = estimate.parameters;
    near.startCubic = estimate.cubic->k3;
    Estimate better = estimateCompleted(again, near);
    if (better.status != EstimateStatus::Converged)
        return estimate;
    better.iterations += estimate.iterations;
    return better;
}

} // namespace gripscope
