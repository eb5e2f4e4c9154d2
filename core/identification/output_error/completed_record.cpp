// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/completed_record.h"

#include "core/identification/output_error/output_error.h"

#include <cmath>

namespace gripscope {

namespace {

/// The largest ratio of standard errors with unknown lost forces to those with known ones.
double growthOfErrors(const Estimate& unknown, const Estimate& known)
{
    if (!unknown.covariance || !known.covariance)
        return 1;
    const Eigen::Vector3d ratios = unknown.covariance->diagonal().cwiseQuotient(known.covariance->diagonal());
    const double largest = std::sqrt(ratios.maxCoeff());
    return std::isfinite(largest) && largest > 1 ? largest : 1;
}

} // namespace

CompletedRecord completedRecord(const std::vector<double>& force, const std::vector<double>& position,
                                const ContinuousTimeOptions& options)
{
    CompletedRecord record;
    record.force = force;
    record.position = position;
    record.outputError.status = EstimateStatus::Converged;
    if (options.lost.empty() || force.size() != position.size())
        return record;
    OutputErrorOptions asked{options};
    asked.residuals = ResidualDepth::Sums;
    record.lost = makeOutputErrorProblem(force, position, options).lost;
    record.outputError = estimateOutputError(force, position, asked);
    if (!record.outputError.parameters)
        return record;
    for (std::size_t i = 0; i < record.lost.size(); ++i) {
        record.force[record.lost[i]] = record.outputError.lostForces[i];
        record.position[record.lost[i]] = record.outputError.simulated[record.lost[i]];
    }
    asked.lost.clear();
    asked.start = record.outputError.parameters;
    record.errorFactor =
        growthOfErrors(record.outputError, estimateOutputError(record.force, record.position, asked));
    return record;
}

OutputErrorProblem completedProblem(const CompletedRecord& record, const ContinuousTimeOptions& options)
{
    ContinuousTimeOptions known = options;
    known.lost.clear();
    OutputErrorProblem problem = makeOutputErrorProblem(record.force, record.position, known);
    problem.lost = record.lost;
    return problem;
}

} // namespace gripscope
