// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/instrumental/instrumental_variables.h"

#include "core/base/words.h"
#include "core/identification/model/discretization.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/output_error/completed_record.h"
#include "core/identification/output_error/output_error_search.h"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace gripscope {

namespace {

Estimate failedInstrumental(EstimateStatus status, const Finding& message)
{
    return statusOnly(Estimator::InstrumentalVariables, status, message);
}

/// From the start given, then from those found in the data, then from a grid, until one explains the
/// position.
std::optional<InstrumentalResult> findSolution(const OutputErrorProblem& record,
                                               const InstrumentalVariablesOptions& options)
{
    MultiStart<InstrumentalResult> searches(poorShare * positionEnergy(record));
    const auto from = [&](const Eigen::Vector3d& start) {
        return start.allFinite() ? std::optional(iterateInstruments(record, start, options.maxIterations))
                                 : std::nullopt;
    };
    if (options.start)
        searches.run(std::array{record.toTheta(*options.start)}, from);
    if (!searches.isGood())
        searches.run(instrumentalStarts(record), from);
    if (!searches.isGood())
        searches.run(outputErrorGrid(record), from);
    return searches.best();
}

/// s^2 (Z'Phi)^-1 Z'Z (Phi'Z)^-1 in channel units; with Z = Q R it is s^2 (Q'Phi)^-1 (Q'Phi)^-T.
std::optional<Eigen::Matrix3d> covarianceOf(const InstrumentalResult& result,
                                            const MassDampingStiffness& parameters, double degreesOfFreedom)
{
    const Eigen::Matrix3d root = parameters.vector().asDiagonal() * result.cross.inverse();
    const Eigen::Matrix3d covariance = result.model.cost / degreesOfFreedom * (root * root.transpose());
    return covariance.allFinite() ? std::optional(covariance) : std::nullopt;
}

/// Simulated in the record's units, where nothing overflows.
std::vector<double> simulatedPositions(const OutputErrorProblem& record, const AuxiliaryModel& model)
{
    const Eigen::Vector3d scaled = model.theta.array().exp();
    const double lag = static_cast<double>(record.lag.samples) + record.lag.rest;
    std::vector<double> positions = simulate({scaled(0), scaled(1), scaled(2)}, record.force,
                                             {1.0, record.hold, lag, model.x0, model.v0, model.offset});
    for (double& y : positions)
        y = y * record.positionScale + record.positionShift;
    return positions;
}

/// The fixed point in channel units.
Estimate inChannelUnits(const OutputErrorProblem& record, const InstrumentalResult& result,
                        const std::vector<double>& position)
{
    const MassDampingStiffness parameters = record.toChannelUnits(result.model.theta);
    const Eigen::Vector3d p = parameters.vector();
    if (!p.allFinite() || !(p.minCoeff() > 0))
        return failedInstrumental(EstimateStatus::NotIdentifiable,
                                  Words::say("m, b or k is outside the range of numbers"));
    Estimate estimate =
        result.outcome == SearchOutcome::Converged
            ? failedInstrumental(EstimateStatus::Converged, Words::say("converged"))
            : failedInstrumental(EstimateStatus::NotConverged, Words::say("the iteration did not settle"));
    estimate.parameters = parameters;
    estimate.nuisance = nuisanceInChannelUnits(record, result.model.x0, result.model.v0, result.model.offset);
    const double freedom = result.degreesOfFreedom(record);
    estimate.covariance = covarianceOf(result, parameters, freedom);
    estimate.residuals.degreesOfFreedom = freedom;
    estimate.simulated = simulatedPositions(record, result.model);
    const InstrumentRows rows = instrumentRows(record, result.model);
    describeResiduals(record, position, rows.columns, rows.residuals, estimate);
    return estimate;
}

} // namespace

Estimate estimateInstrumentalVariables(const std::vector<double>& force, const std::vector<double>& position,
                                       const InstrumentalVariablesOptions& options)
{
    if (force.size() != position.size())
        return failedInstrumental(EstimateStatus::NotApplicable,
                                  Words::say("force and position have different lengths"));
    const std::size_t unknowns = 3 + (options.freeInitialState ? 2 : 0) + (options.freeOffset ? 1 : 0);
    if (force.size() <= unknowns)
        return failedInstrumental(
            EstimateStatus::TooFewSamples,
            Words::say("there are fewer samples than there are unknowns; record for longer"));
    const CompletedRecord completed = completedRecord(force, position, options);
    if (!options.lost.empty() && !completed.outputError.parameters)
        return failedInstrumental(completed.outputError.status, completed.outputError.message);
    const OutputErrorProblem record = completedProblem(completed, options);
    if (record.measuredRows() <= static_cast<std::ptrdiff_t>(unknowns))
        return failedInstrumental(EstimateStatus::TooFewSamples,
                                  Words::say("the lag between the channels leaves too few samples"));
    if (isConstant(completed.position))
        return failedInstrumental(EstimateStatus::NotIdentifiable, Words::say(constantPosition));
    const std::optional<InstrumentalResult> result = findSolution(record, options);
    if (!result)
        return failedInstrumental(EstimateStatus::NotIdentifiable, isConstant(completed.force)
                                                                       ? Words::say(constantForce)
                                                                       : Words::say(noAnswer));
    Estimate estimate = failedInstrumental(EstimateStatus::NotIdentifiable, Finding());
    if (!result->isDetermined())
        estimate.message = Words::say(isConstant(completed.force) ? constantForce : poorForce);
    else if (result->outcome == SearchOutcome::Boundary)
        estimate.message = boundaryMessage(result->boundaryIndex, result->boundaryAtZero);
    else
        estimate = inChannelUnits(record, *result, completed.position);
    if (estimate.covariance)
        *estimate.covariance *= completed.errorFactor * completed.errorFactor;
    estimate.iterations = result->iterations;
    return estimate;
}

} // namespace gripscope
