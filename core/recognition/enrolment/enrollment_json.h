// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/enrolment/enrollment_progress.h"
#include "core/recognition/enrolment/held_out_confusion.h"
#include "core/recognition/enrolment/squeeze_outliers.h"
#include "core/recognition/enrolment/type_overlap.h"

#include <QJsonObject>

namespace gripscope {

// What `gripscope-cli types guide --json` and `types confusion --json` say.

/// squeezes, more_for_gate, gate, gate_limit, strangers_passing, strangers_limit, more_for_most (null: over
/// 100), stiffness_uncertainty, words.
[[nodiscard]] QJsonObject toJson(const EnrollmentProgress& progress);
/// deviations, chance, parameter ("m", "b", "k", "k1/k", "tau", "Fc" or null), reason.
[[nodiscard]] QJsonObject toJson(const SqueezeOutlier& outlier);
/// other, undecided, wrong, undecided_of_other, words.
[[nodiscard]] QJsonObject toJson(const TypeOverlap& overlap);
/// confusion (by true type: by verdict), squeezes, parts, untested, wrong_type and unknown with their bounds.
[[nodiscard]] QJsonObject toJson(const HeldOutConfusion& confusion);

} // namespace gripscope
