// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/assessment.h"

#include "core/identification/identification.h"

#include <algorithm>

namespace gripscope {

namespace {

/// A Duffing search takes some microseconds a sample and iteration: a second for this many.
constexpr std::size_t longestCubic = 100'000;

} // namespace

ModelDiscrepancy windowDiscrepancy(const PreparedRecord& record, const EstimatorTask& task,
                                   const Estimate& whole)
{
    EstimatorTask each = task;
    each.freeInitialState = true;
    // Windows of a repeating force need not hold whole periods.
    const Estimator estimator =
        whole.estimator == Estimator::Duffing ? Estimator::Duffing : Estimator::OutputError;
    return modelDiscrepancy(record.force.size(), record.sampleTime_s, whole, [&](Window window) {
        return runEstimator(estimator, windowOf(record, window), each);
    });
}

UncertaintyBudget budgetOf(const Estimate& estimate, const PreparedRecord& record, const EstimatorTask& task,
                           const HoldEvidence& holds)
{
    BudgetOptions options;
    if (holds.parameters && holds.otherParameters && estimate.parameters) {
        // As far from this estimate as output error moves with the hold, whichever estimator this is.
        const Eigen::Vector3d ratio =
            holds.otherParameters->vector().cwiseQuotient(holds.parameters->vector());
        const Eigen::Vector3d other = estimate.parameters->vector().cwiseProduct(ratio);
        options.hold = HoldAmbiguity{{other(0), other(1), other(2)}, holds.otherProbability()};
    }
    options.discrepancy = windowDiscrepancy(record, task, estimate);
    return uncertaintyBudget(estimate, record.force, record.position, outputErrorOptions(record, task),
                             record.chain, options);
}

ModelComparison comparisonOf(const Identification& identification, const PreparedRecord& record,
                             const EstimatorTask& task)
{
    const Estimate* const linear = identification.find(Estimator::OutputError);
    if (linear == nullptr || linear->status != EstimateStatus::Converged)
        return {};
    std::optional<Estimate> cubic;
    if (const Estimate* const found = identification.find(Estimator::Duffing))
        cubic = *found;
    else if (record.lost.empty() && record.force.size() <= longestCubic)
        cubic = runEstimator(Estimator::Duffing, record, task);
    if (cubic && cubic->status != EstimateStatus::Converged)
        cubic.reset();
    return compareModels(record.force, record.position, outputErrorOptions(record, task), *linear, cubic);
}

} // namespace gripscope
