// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/recognition/verdict/verdict.h"

#include <optional>

namespace gripscope {

/// How far an enrolment is from what more squeezes can give.
struct EnrollmentProgress {
    QString type;
    int squeezes = 0;
    double falseReject = 0; ///< the rate that the gate is for
    /// Of strangers anywhere in the instrument's range, the share that may be named a type; absent where
    /// nothing is said of them.
    std::optional<double> strangerAccept;
    /// Squeezes that are missing until there is a gate; 0: there is one.
    int moreForGate = 0;
    /// Where a squeeze is called unknown, in standard deviations; and where it would be if everything were
    /// known: sqrt of the chi-square quantile.
    std::optional<double> gate;
    double gateLimit = 0;
    /// Share of the squeezes of a part that lies 6 standard deviations away that pass the gate, on average
    /// over enrolments (noncentral F); and if everything were known (noncentral chi-square).
    std::optional<double> strangersPassing;
    double strangersLimit = 0;
    /// Squeezes until the gate is within a quarter of its limit; 0: it is. Absent: over 100.
    std::optional<int> moreForMost;
    /// How far the type's stiffness may lie from what was found (95 %, a share of it); absent where nothing
    /// is known of how squeezes differ, or in a space without stiffness.
    std::optional<double> stiffnessUncertainty;
};

/// `models`: of all types, with this one in it or not yet. The gate is the predictive one at the false-reject
/// rate, or the tolerance gate where a confidence is asked for.
[[nodiscard]] EnrollmentProgress enrollmentProgress(const TypeModels& models, const QString& type,
                                                    const VerdictOptions& options);
/// What a technician should know and do next, in sentences.
[[nodiscard]] Findings inWords(const EnrollmentProgress& progress);

} // namespace gripscope
