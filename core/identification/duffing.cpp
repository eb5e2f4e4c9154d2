// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing.h"

#include "core/identification/duffing_search.h"
#include "core/identification/duffing_start.h"
#include "core/identification/fit.h"
#include "core/identification/identifiability.h"
#include "core/identification/output_error.h"
#include "core/identification/scaled_residuals.h"
#include "core/identification/tall_qr.h"
#include "core/words.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// Of longer records a first part is enough to find the way.
constexpr std::size_t firstPart = 8000;
/// Largest shift of a parameter by the integration, in standard errors; and the integration's error beside
/// the positions where there is no noise.
constexpr double toleratedShift = 0.01, toleratedError = 1e-9;
constexpr int mostSubsteps = 256;

Estimate failed(EstimateStatus status, const char* message)
{
    return statusOnly(Estimator::Duffing, status, message);
}

/// The same record for a linear spring.
OutputErrorOptions linearOptions(const DuffingOptions& options)
{
    OutputErrorOptions linear;
    linear.sampleTime_s = options.sampleTime_s;
    linear.hold = options.hold;
    linear.lag_s = options.lag_s;
    linear.freeInitialState = options.freeInitialState;
    linear.freeOffset = options.freeOffset;
    return linear;
}

DuffingProblem scaledProblem(const std::vector<double>& force, const std::vector<double>& position,
                             const DuffingOptions& options)
{
    return {makeOutputErrorProblem(force, position, linearOptions(options)), 1};
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
    const Estimate estimate = estimateOutputError(force, position, linearOptions(options));
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

bool isDetermined(const DuffingSearchResult& search)
{
    return search.linear.finite && scaledConditionNumber(search.linear.projected) <= largestCondition;
}

bool isSettled(const DuffingSearchResult& search)
{
    return search.outcome == DuffingOutcome::Converged && isDetermined(search);
}

/// From one start after the other until one leads to an optimum that explains the position; the best of them.
std::optional<DuffingSearchResult> searchFrom(DuffingProblem& problem,
                                              const std::vector<DuffingPoint>& starts, int maxIterations)
{
    std::optional<DuffingSearchResult> best;
    const double poor = poorShare * positionEnergy(problem);
    for (const DuffingPoint& start : starts) {
        problem.substeps = suitableSubsteps(start, largestMotion(problem, start));
        const DuffingSearchResult search = searchDuffing(problem, start, maxIterations);
        const bool better =
            best && isSettled(search) && (!isSettled(*best) || search.linear.cost < best->linear.cost);
        if (!best || better)
            best = search;
        if (isSettled(*best) && best->linear.cost <= poor)
            break;
    }
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
    const auto count = static_cast<double>(problem.rows());
    const double size = std::sqrt(positionEnergy(problem) / count);
    while (search.linear.finite && problem.substeps < mostSubsteps) {
        const double noise = std::sqrt(search.linear.cost / search.degreesOfFreedom(problem));
        const double tolerated = std::max(toleratedShift * noise / std::sqrt(count), toleratedError * size);
        const double error = integrationError(problem, search.point);
        if (error <= tolerated)
            return;
        // The error falls with the fourth power of the step.
        const double factor = std::clamp(std::ceil(1.1 * std::pow(error / tolerated, 0.25)), 2.0, 16.0);
        problem.substeps = std::min(static_cast<int>(factor) * problem.substeps, mostSubsteps);
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
            if (found && isSettled(*found) && found->linear.cost <= poorShare * positionEnergy(part))
                return {found->point};
        }
    }
    return duffingStarts(problem, knownStarts(problem, force, position, options));
}

/// s^2 (J'J)^-1 in channel units: d theta_i = d p_i / p_i.
std::optional<Eigen::Matrix4d> covarianceOf(const DuffingSearchResult& search, const Eigen::Vector4d& units,
                                            double degreesOfFreedom)
{
    const Eigen::Matrix4d factor =
        Eigen::HouseholderQR<Eigen::MatrixXd>(search.linear.projected).matrixQR().topRows<4>();
    const Eigen::Matrix4d inverse = Eigen::Matrix4d(factor.triangularView<Eigen::Upper>()).inverse();
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

const char* boundaryMessage(const DuffingSearchResult& search)
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
    static constexpr std::array<const char*, 3> toInfinity{
        QT_TRANSLATE_NOOP("Words", "no finite mass explains the position; check the grip and the sensor"),
        QT_TRANSLATE_NOOP("Words", "no finite damping explains the position; check the grip and the sensor"),
        QT_TRANSLATE_NOOP("Words",
                          "no finite stiffness explains the position; check the grip and the sensor")};
    const auto i = static_cast<std::size_t>(search.boundaryIndex);
    return search.boundaryAtZero ? toZero[i] : toInfinity[i];
}

/// What keeps the estimator from starting, or nothing.
std::optional<Estimate> obstacle(const std::vector<double>& force, const std::vector<double>& position,
                                 const DuffingProblem& problem)
{
    if (problem.rows() <= problem.unknowns())
        return failed(EstimateStatus::TooFewSamples,
                      QT_TRANSLATE_NOOP("Words", "the lag between the channels leaves too few samples"));
    if (isConstant(position))
        return failed(EstimateStatus::NotIdentifiable, constantPosition);
    if (isConstant(force) && problem.freeInitialState)
        return failed(
            EstimateStatus::NotIdentifiable,
            QT_TRANSLATE_NOOP(
                "Words",
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
        return failed(
            EstimateStatus::NotIdentifiable,
            QT_TRANSLATE_NOOP("Words", "m, b, k, k3 or their errors are outside the range of numbers"));
    const bool converged = search.outcome == DuffingOutcome::Converged;
    Estimate estimate = converged ? failed(EstimateStatus::Converged, QT_TRANSLATE_NOOP("Words", "converged"))
                                  : failed(EstimateStatus::NotConverged,
                                           QT_TRANSLATE_NOOP("Words", "the search did not settle"));
    estimate.parameters = parameters;
    estimate.covariance = covariance->topLeftCorner<3, 3>();
    estimate.cubic = CubicSpring{k3, *covariance};
    estimate.nuisance =
        nuisanceInChannelUnits(problem, search.point.x0, search.point.v0, search.point.offset);
    describe(problem, search, position, estimate);
    return estimate;
}

} // namespace

Estimate estimateDuffing(const std::vector<double>& force, const std::vector<double>& position,
                         const DuffingOptions& options)
{
    if (!options.lost.empty())
        return failed(
            EstimateStatus::NotApplicable,
            QT_TRANSLATE_NOOP(
                "Words", "the cubic spring needs an unbroken record; choose a window without lost samples"));
    if (force.size() != position.size())
        return failed(EstimateStatus::NotApplicable,
                      QT_TRANSLATE_NOOP("Words", "force and position have different lengths"));
    const std::size_t unknowns = 4 + (options.freeInitialState ? 2 : 0) + (options.freeOffset ? 1 : 0);
    if (force.size() <= unknowns)
        return failed(
            EstimateStatus::TooFewSamples,
            QT_TRANSLATE_NOOP(
                "Words", "there are fewer samples than the cubic spring has unknowns; record for longer"));
    DuffingProblem problem = scaledProblem(force, position, options);
    if (const std::optional<Estimate> stop = obstacle(force, position, problem))
        return *stop;
    const std::vector<DuffingPoint> starts = startsFor(problem, force, position, options);
    std::optional<DuffingSearchResult> search = searchFrom(problem, starts, options.maxIterations);
    if (!search || search->outcome == DuffingOutcome::Lost)
        return failed(EstimateStatus::NotIdentifiable, noAnswer);
    if (isSettled(*search))
        settleIntegration(problem, *search, options.maxIterations);
    Estimate estimate = failed(EstimateStatus::NotIdentifiable, "");
    if (search->outcome == DuffingOutcome::Boundary)
        estimate.message = boundaryMessage(*search);
    else if (!isDetermined(*search))
        estimate.message = QT_TRANSLATE_NOOP(
            "Words", "this force does not determine m, b, k and k3; squeeze with a richer one");
    else
        estimate = inChannelUnits(problem, *search, position);
    estimate.iterations = search->iterations;
    return estimate;
}

std::vector<double> simulateDuffing(const MassDampingStiffness& parameters, double k3,
                                    const std::vector<double>& force, const SimulationOptions& options)
{
    constexpr double exact = 1e-10;
    DuffingProblem problem;
    problem.hold = options.hold;
    problem.lag = LagAlignment(options.lag_s, options.sampleTime_s);
    problem.sampleTime_s = options.sampleTime_s;
    problem.forceScale = powerOfTwoScale(force);
    problem.force = force;
    for (double& value : problem.force)
        value /= problem.forceScale;
    const double swing = options.v0 * std::sqrt(parameters.m / parameters.k);
    const std::array<double, 3> sizes{problem.forceScale / parameters.k, options.x0, swing};
    problem.positionScale = powerOfTwoScale(sizes);
    DuffingPoint point = pointFrom(problem, parameters, k3, {options.x0, options.v0, {}});
    problem.substeps = suitableSubsteps(point, 1);
    std::vector<double> positions = positionsAt(problem, point);
    while (!positions.empty() && problem.substeps <= mostSubsteps) {
        problem.substeps *= 2;
        const std::vector<double> finer = positionsAt(problem, point);
        double change = 0;
        for (std::size_t i = 0; i < finer.size(); ++i)
            change = std::max(change, std::abs(finer[i] - positions[i]));
        positions = finer;
        if (change < exact)
            break;
    }
    for (double& x : positions)
        x = x * problem.positionScale + options.offset;
    return positions;
}

} // namespace gripscope
