// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/instrumental_variables.h"

#include "core/identification/discretization.h"
#include "core/identification/identifiability.h"
#include "core/identification/instrumental_variables_search.h"
#include "core/identification/output_error_start.h"
#include "core/identification/scaled_residuals.h"
#include "core/identification/tall_qr.h"
#include "core/words.h"

#include <Eigen/LU>

#include <cmath>

namespace gripscope {

namespace {

Estimate failed(EstimateStatus status, const char* message)
{
    return statusOnly(Estimator::InstrumentalVariables, status, message);
}

OutputErrorOptions reading(const InstrumentalVariablesOptions& options)
{
    OutputErrorOptions same;
    same.sampleTime_s = options.sampleTime_s;
    same.hold = options.hold;
    same.lag_s = options.lag_s;
    same.freeInitialState = options.freeInitialState;
    same.freeOffset = options.freeOffset;
    return same;
}

bool isDetermined(const InstrumentalResult& result)
{
    return result.model.finite && result.equations.finite && result.model.ownShare >= smallestOwnShare &&
           scaledConditionNumber(result.equations.instruments) <= largestCondition;
}

bool isSettled(const InstrumentalResult& result)
{
    return result.outcome == InstrumentalOutcome::Converged && isDetermined(result);
}

/// Iterates from one start after the other; keeps the best fixed point, or else the first answer.
class Tries {
public:
    Tries(const ScaledRecord& record, int maxIterations)
        : m_record(record), m_maxIterations(maxIterations), m_poor(poorShare * positionEnergy(record))
    {
    }
    void run(const std::vector<Eigen::Vector3d>& starts)
    {
        for (const Eigen::Vector3d& start : starts) {
            if (!start.allFinite())
                continue;
            const InstrumentalResult result = iterateInstruments(m_record, start, m_maxIterations);
            const bool better = m_best && isSettled(result) &&
                                (!isSettled(*m_best) || result.model.cost < m_best->model.cost);
            if (!m_best || better)
                m_best = result;
            if (good())
                return;
        }
    }
    [[nodiscard]] bool good() const { return m_best && isSettled(*m_best) && m_best->model.cost <= m_poor; }
    [[nodiscard]] std::optional<InstrumentalResult> best() const { return m_best; }

private:
    const ScaledRecord& m_record;
    int m_maxIterations;
    double m_poor;
    std::optional<InstrumentalResult> m_best;
};

/// From the start given, then from those found in the data, then from a grid, until one explains the
/// position.
std::optional<InstrumentalResult> findSolution(const ScaledRecord& record,
                                               const InstrumentalVariablesOptions& options)
{
    Tries tries(record, options.maxIterations);
    if (options.start)
        tries.run({record.toTheta(*options.start)});
    if (!tries.good())
        tries.run(instrumentalStarts(record));
    if (!tries.good())
        tries.run(outputErrorGrid(record));
    return tries.best();
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
std::vector<double> simulatedPositions(const ScaledRecord& record, const AuxiliaryModel& model)
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
Estimate inChannelUnits(const ScaledRecord& record, const InstrumentalResult& result,
                        const std::vector<double>& position)
{
    const MassDampingStiffness parameters = record.toChannelUnits(result.model.theta);
    const Eigen::Vector3d p = parameters.vector();
    if (!p.allFinite() || !(p.minCoeff() > 0))
        return failed(EstimateStatus::NotIdentifiable,
                      QT_TRANSLATE_NOOP("Words", "m, b or k is outside the range of numbers"));
    Estimate estimate = result.outcome == InstrumentalOutcome::Converged
                            ? failed(EstimateStatus::Converged, QT_TRANSLATE_NOOP("Words", "converged"))
                            : failed(EstimateStatus::NotConverged,
                                     QT_TRANSLATE_NOOP("Words", "the iteration did not settle"));
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
    if (!options.lost.empty())
        return failed(
            EstimateStatus::NotApplicable,
            QT_TRANSLATE_NOOP(
                "Words",
                "instrumental variables need an unbroken record; choose a window without lost samples"));
    if (force.size() != position.size())
        return failed(EstimateStatus::NotApplicable,
                      QT_TRANSLATE_NOOP("Words", "force and position have different lengths"));
    const std::size_t unknowns = 3 + (options.freeInitialState ? 2 : 0) + (options.freeOffset ? 1 : 0);
    if (force.size() <= unknowns)
        return failed(
            EstimateStatus::TooFewSamples,
            QT_TRANSLATE_NOOP("Words", "there are fewer samples than there are unknowns; record for longer"));
    const ScaledRecord record = makeOutputErrorProblem(force, position, reading(options));
    if (record.rows() <= static_cast<std::ptrdiff_t>(unknowns))
        return failed(EstimateStatus::TooFewSamples,
                      QT_TRANSLATE_NOOP("Words", "the lag between the channels leaves too few samples"));
    if (isConstant(position))
        return failed(EstimateStatus::NotIdentifiable, constantPosition);
    const std::optional<InstrumentalResult> result = findSolution(record, options);
    if (!result)
        return failed(EstimateStatus::NotIdentifiable, isConstant(force) ? constantForce : noAnswer);
    Estimate estimate = failed(EstimateStatus::NotIdentifiable, "");
    if (!isDetermined(*result))
        estimate.message =
            isConstant(force)
                ? constantForce
                : QT_TRANSLATE_NOOP("Words",
                                    "this force does not determine m, b and k; squeeze with a richer one");
    else if (result->outcome == InstrumentalOutcome::Boundary)
        estimate.message = boundaryMessage(result->boundaryIndex, result->boundaryAtZero);
    else
        estimate = inChannelUnits(record, *result, position);
    estimate.iterations = result->iterations;
    return estimate;
}

} // namespace gripscope
