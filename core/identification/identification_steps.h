// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimators/run_estimator.h"
#include "core/identification/result/identification_result.h"

#include <cstdint>
#include <optional>

namespace gripscope {

// What identify() does beyond running estimators: the terms that it tries besides, the mass that it leaves
// out, and the budget of what it recommends.

/// What is tried besides output error: each further term alone, side by side, and the two that help most
/// together where each helps much.
struct FurtherTerms {
    std::optional<Estimate> cubic, friction, relaxing, together;
    double unsettledYielding = 0; ///< as ModelComparison's

    static constexpr std::int64_t parts = 3;
    /// One of the terms alone; the parts may be found at the same time.
    void findPart(std::int64_t part, const Identification& identification, const PreparedRecord& record,
                  const EstimatorTask& task);
    /// After all parts.
    void findTogether(const Identification& identification, const PreparedRecord& record,
                      const EstimatorTask& task);

private:
    void findYielding(const Identification& identification, const PreparedRecord& record,
                      const EstimatorTask& task);
};

/// Output error of the record against other models. Empty without a converged output-error estimate.
[[nodiscard]] ModelComparison comparisonOf(const Identification& identification, const PreparedRecord& record,
                                           const EstimatorTask& task, const Estimate& otherHold,
                                           const FurtherTerms& further);

/// The motion with further terms that explains the record decisively better, if one does. A cubic spring
/// alone is none: it is believed where it was asked for.
[[nodiscard]] const Estimate* betterMotion(const ModelComparison& comparison);

/// Says so in the comparison's sentence: "friction of 0.4 N explains this squeeze; without it k would read 4
/// % high".
void nameFurtherTerms(Identification& data, const QString& forceUnit);

/// The same motion without its mass: `static` for `oe`, `static+zener` for `zener`, `static+duffing` for
/// `duffing`; nothing for the others.
[[nodiscard]] std::optional<Estimator> withoutMass(Estimator estimator);

/// Where the record does not tell the mass of the motion that is recommended (of output error, where that
/// ends at no mass), the motion without it is recommended: what the sample time is too long for is not made
/// up. Not told is a mass
/// - that the search took to zero, or that the force does not determine though its levels tell stiffness from
///   friction;
/// - whose leaving out costs the likelihood less than decisiveDelta and ln N for each unknown less (BIC under
///   white noise), unless its standard error is below a fiftieth of it.
/// Nothing changes where the motion without a mass finds nothing. Run where it was not asked for.
void leaveOutUntoldMass(Identification& data, const PreparedRecord& record, const EstimatorTask& task);

/// The budget of the estimate that an identification recommends: its noise, the counts, the chain's effects,
/// the other hold as far as that is probable, and what windows of the record disagree by. Of a motion without
/// all of m, b and k the lines are in `further` (MotionDoubts): its other form is a carriage with friction of
/// its own each way, or, where the mass was left out, the motion that has one. Without parameters and
/// covariance: a budget that says why there is none. `holdIsDeclared`: nobody had to assume it.
[[nodiscard]] UncertaintyBudget squeezeBudget(const Identification& data, const PreparedRecord& record,
                                              const EstimatorTask& task, bool holdIsDeclared);

} // namespace gripscope
