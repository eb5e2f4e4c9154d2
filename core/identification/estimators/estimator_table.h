// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimators/run_estimator.h"

#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// Where plots draw an estimate: a regular polygon, one corner at `turn` (radians from the right, clockwise),
/// its radius `size` times that of the circle; no corners: the circle.
struct EstimatorSign {
    int corners = 0;
    double size = 1, turn = 0;
};

/// All that is known of an estimator wherever it is named, chosen, run or drawn. A new one is a line of this
/// table, an enumerator and files of its own.
struct EstimatorFacts {
    Estimator estimator;
    const char* id;     ///< in documents, on the command line, in the library
    const char* name;   ///< short, for pages; English that Words::say() takes
    const char* title;  ///< whole, for the command line
    bool takesLost;     ///< lost samples are unknown to it; else it gets the longest stretch without any
    bool assumesLinear; ///< what studies of efficiency on linear objects compare
    bool onPages;       ///< among those that pages run side by side; the others where they are asked for
    EstimatorSign sign;
    /// On a record that is as it takes it.
    Estimate (*run)(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task,
                    std::optional<PeriodicDiagnostics>* repetition);
};

/// All of them, in the order of the enumerators.
[[nodiscard]] std::span<const EstimatorFacts> estimatorTable();
[[nodiscard]] std::vector<Estimator> allEstimators();
/// Those that pages run and offer, in their order.
[[nodiscard]] std::vector<Estimator> estimatorsOnPages();
/// Those of them whose m, b and k a type can be made of.
[[nodiscard]] std::vector<Estimator> estimatorsOfTypes();
/// The terms of an estimator of the family of MotionTerms; nothing for the others.
[[nodiscard]] std::optional<MotionTerms> motionTermsOf(Estimator estimator);
[[nodiscard]] const EstimatorFacts& factsOf(Estimator estimator);

} // namespace gripscope
