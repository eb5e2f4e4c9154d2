// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/agreement/attribute_agreement.h"
#include "core/quality/bias/linearity_study.h"
#include "core/quality/bias/type_one_study.h"
#include "core/session/quality/gauge_result.h"
#include "core/session/quality/referenced_readings.h"

#include <variant>

namespace gripscope {

struct TypeOneResult {
    ReferencedReadings readings;
    TypeOneOptions options;
    TypeOneStudy study;
};

struct LinearityResult {
    ReferencedReadings readings;
    LinearityStudy study;
};

/// What a study says, of whatever kind.
struct StudyResult {
    std::variant<GaugeResult, TypeOneResult, LinearityResult, AttributeAgreement> found;
    Findings verdict; ///< the plain sentences, the most telling first
    std::size_t left = 0, skipped = 0, repeated = 0;

    /// The result of that kind, or null.
    template <typename Result>
    [[nodiscard]] const Result* as() const
    {
        return std::get_if<Result>(&found);
    }
    [[nodiscard]] const GaugeResult* gauge() const { return as<GaugeResult>(); }
};

/// Of what counts; pure. Errors: as gaugeResult(), studyTypeOne(), studyLinearity() and studyAgreement()
/// have; Usage for a type-1 study without a tolerance of its quantity, BadInput where no measurement counts.
[[nodiscard]] Expected<StudyResult> resultOf(const KeptStudy& study);

} // namespace gripscope
