// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimators/run_estimator.h"
#include "core/identification/result/identification_result.h"

#include <cstdint>
#include <optional>

namespace gripscope {

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

} // namespace gripscope
