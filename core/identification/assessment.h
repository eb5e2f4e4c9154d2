// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/hold_evidence.h"
#include "core/identification/model_comparison.h"
#include "core/identification/run_estimator.h"
#include "core/identification/uncertainty_budget.h"

namespace gripscope {

struct Identification;

/// The disagreement between windows of the record as `estimator` sees them, output error on each with its own
/// lost samples. `whole` is the estimate from all of it.
[[nodiscard]] ModelDiscrepancy windowDiscrepancy(const PreparedRecord& record, const EstimatorTask& task,
                                                 const Estimate& whole);

/// The budget of `estimate`: its noise, the chain's effects, the other hold as far as `holds` leaves it
/// probable, and what the windows disagree by. Without parameters and covariance: a budget that says why
/// there is none.
[[nodiscard]] UncertaintyBudget budgetOf(const Estimate& estimate, const PreparedRecord& record,
                                         const EstimatorTask& task, const HoldEvidence& holds);

/// Output error of the record against other models; a cubic spring is tried where no sample is lost and the
/// record is short enough for it to be quick. Empty without a converged output-error estimate.
[[nodiscard]] ModelComparison comparisonOf(const Identification& identification, const PreparedRecord& record,
                                           const EstimatorTask& task);

} // namespace gripscope
