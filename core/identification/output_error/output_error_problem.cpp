// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error_problem.h"

#include "core/identification/model/identifiability.h"
#include "core/identification/noise/residual_tests.h"
#include "core/math/fit.h"
#include "core/math/least_squares.h"
#include "core/math/sequential_qr.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace gripscope {

namespace {

std::vector<std::size_t> sortedWithin(std::vector<std::size_t> lost, std::size_t count)
{
    std::sort(lost.begin(), lost.end());
    lost.erase(std::unique(lost.begin(), lost.end()), lost.end());
    lost.erase(std::lower_bound(lost.begin(), lost.end(), count), lost.end());
    return lost;
}

/// Straight lines over the lost samples, the nearest measured value before the first and after the last.
void fillLost(std::vector<double>& values, const std::vector<std::size_t>& lost)
{
    for (std::size_t i = 0; i < lost.size();) {
        std::size_t end = i + 1;
        while (end < lost.size() && lost[end] == lost[end - 1] + 1)
            ++end;
        const std::size_t first = lost[i];
        const std::size_t next = lost[end - 1] + 1;
        const bool before = first > 0;
        const bool after = next < values.size();
        const double left = before ? values[first - 1] : (after ? values[next] : 0);
        const double right = after ? values[next] : left;
        const auto span = static_cast<double>(next - first + 1);
        for (std::size_t t = first; t < next; ++t) {
            const double share = static_cast<double>(t - first + 1) / span;
            values[t] = (1 - share) * left + share * right;
        }
        i = end;
    }
}

void scaleDown(std::vector<double>& values, double scale)
{
    for (double& value : values)
        value /= scale;
}

double squaredSum(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return sum;
}

void testResiduals(const OutputErrorProblem& record, const Eigen::MatrixXd& columns,
                   const std::vector<double>& residuals, ResidualSummary& summary)
{
    const Eigen::Index model = columns.cols();
    constexpr auto extra = static_cast<Eigen::Index>(inputLags.size());
    SequentialQr qr(model + extra + 1);
    std::ptrdiff_t index = record.firstRow();
    for (Eigen::Index i = 0; i < columns.rows(); ++i, ++index) {
        while (record.isLost(index))
            ++index;
        const std::ptrdiff_t at = std::max<std::ptrdiff_t>(index + record.lag.samples, 0);
        auto row = qr.nextRow();
        row.head(model) = columns.row(i);
        row.segment<extra>(model) = laggedInputs(record.force, static_cast<std::size_t>(at));
        row(model + extra) = residuals[static_cast<std::size_t>(i)];
    }
    const Eigen::MatrixXd triangle = qr.triangle();
    summary.whitenessP = ljungBoxP(residuals, 0);
    summary.inputIndependenceP = extraColumnsP(triangle, extra, static_cast<double>(columns.rows()));
    const Eigen::Index nuisances = record.nuisanceCount();
    const Eigen::Index others = model - nuisances;
    Eigen::MatrixXd own = columns.rightCols(others);
    if (nuisances > 0) {
        const PivotedSolution explained = solvePivoted(triangle.topLeftCorner(nuisances, nuisances),
                                                       triangle.block(0, nuisances, nuisances, others));
        own -= columns.leftCols(nuisances) * explained.solution;
    }
    summary.errorInflation = errorInflation(own, residuals);
}

} // namespace

OutputErrorProblem makeOutputErrorProblem(const std::vector<double>& force,
                                          const std::vector<double>& position,
                                          const ContinuousTimeOptions& options)
{
    OutputErrorProblem problem;
    problem.hold = options.hold;
    problem.lag = LagAlignment(options.lag_s, options.sampleTime_s);
    problem.freeInitialState = options.freeInitialState;
    problem.freeOffset = options.freeOffset;
    problem.sampleTime_s = options.sampleTime_s;
    problem.lost = sortedWithin(options.lost, force.size());
    if (problem.lost.empty()) {
        problem.force = force;
    } else {
        LostForcePrior prior = lostForcePrior(force, problem.lost);
        problem.force = std::move(prior.force);
        problem.lostForceDeviation = std::move(prior.deviation);
    }
    problem.forceScale = powerOfTwoScale(problem.force);
    scaleDown(problem.force, problem.forceScale);
    scaleDown(problem.lostForceDeviation, problem.forceScale);
    problem.position = position;
    fillLost(problem.position, problem.lost);
    if (options.freeOffset) {
        // A free offset takes any constant up; without the largest part of it less is lost to rounding.
        problem.positionShift = problem.position.front();
        for (double& value : problem.position)
            value -= problem.positionShift;
    }
    problem.positionScale = powerOfTwoScale(problem.position);
    scaleDown(problem.position, problem.positionScale);
    return problem;
}

std::ptrdiff_t OutputErrorProblem::firstRow() const
{
    return std::max<std::ptrdiff_t>(-lag.samples, 0);
}

std::ptrdiff_t OutputErrorProblem::endRow() const
{
    const auto count = static_cast<std::ptrdiff_t>(force.size());
    // Within the last step a straight force would need the sample after it.
    const std::ptrdiff_t unknown = lag.rest > 0 && hold == ForceHold::First ? 1 : 0;
    return std::min(count - lag.samples - unknown, count);
}

std::ptrdiff_t OutputErrorProblem::measuredRows() const
{
    const std::ptrdiff_t all = rows();
    if (all == 0)
        return 0;
    const auto first = std::lower_bound(lost.begin(), lost.end(), static_cast<std::size_t>(firstRow()));
    const auto end = std::lower_bound(first, lost.end(), static_cast<std::size_t>(endRow()));
    return all - (end - first);
}

MassDampingStiffness OutputErrorProblem::toChannelUnits(const Eigen::Vector3d& theta) const
{
    const double scale = forceScale / positionScale;
    return {std::exp(theta(0)) * sampleTime_s * sampleTime_s * scale,
            std::exp(theta(1)) * sampleTime_s * scale, std::exp(theta(2)) * scale};
}

Eigen::Vector3d OutputErrorProblem::toTheta(const MassDampingStiffness& parameters) const
{
    const double scale = std::log(forceScale / positionScale);
    const double time = std::log(sampleTime_s);
    return {std::log(parameters.m) - 2 * time - scale, std::log(parameters.b) - time - scale,
            std::log(parameters.k) - scale};
}

Nuisance nuisanceInChannelUnits(const OutputErrorProblem& record, double x0, double v0, double offset)
{
    Nuisance nuisance;
    if (record.freeInitialState) {
        nuisance.x0 = x0 * record.positionScale;
        nuisance.v0 = v0 * record.positionScale / record.sampleTime_s;
    }
    if (record.freeOffset)
        nuisance.offset = offset * record.positionScale + record.positionShift;
    return nuisance;
}

double squaredSize(const OutputErrorProblem& record)
{
    double sum = 0;
    for (const double y : record.position)
        sum += y * y;
    return sum;
}

double positionEnergy(const OutputErrorProblem& record)
{
    double mean = 0;
    double squares = 0;
    for (const double y : record.position) {
        mean += y;
        squares += y * y;
    }
    const auto count = static_cast<double>(record.position.size());
    return squares - (record.freeOffset ? mean * mean / count : 0);
}

OutputErrorProblem firstSamples(const OutputErrorProblem& record, std::size_t most)
{
    OutputErrorProblem part = record;
    if (part.force.size() > most) {
        part.force.resize(most);
        part.position.resize(most);
    }
    return part;
}

bool isConstant(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
}

void describeResiduals(const OutputErrorProblem& record, const std::vector<double>& position,
                       const Eigen::MatrixXd& columns, const std::vector<double>& residuals,
                       Estimate& estimate)
{
    estimate.residual.assign(position.size(), 0);
    std::vector<double> measured;
    std::vector<double> simulated;
    for (std::size_t i = 0; i < position.size(); ++i) {
        const auto index = static_cast<std::ptrdiff_t>(i);
        if (record.isLost(index))
            continue;
        estimate.residual[i] = position[i] - estimate.simulated[i];
        if (index < record.firstRow() || index >= record.endRow())
            continue;
        measured.push_back(position[i]);
        simulated.push_back(estimate.simulated[i]);
        estimate.residuals.sse += estimate.residual[i] * estimate.residual[i];
    }
    estimate.fit.simulationPercent = fitPercent(measured, simulated);
    estimate.fit.predictionPercent = estimate.fit.simulationPercent;
    estimate.residuals.sse = std::min(estimate.residuals.sse, std::numeric_limits<double>::max());
    if (squaredSum(residuals) > roundingShare * roundingShare * squaredSum(record.position))
        testResiduals(record, columns, residuals, estimate.residuals);
}

} // namespace gripscope
