// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/quality/agreement/attribute_agreement.h"
#include "core/quality/bias/linearity_study.h"
#include "core/quality/bias/type_one_study.h"
#include "core/quality/gauge/gauge_study.h"
#include "core/session/quality/kept_study.h"

#include <variant>

namespace gripscope {

/// The measurements of one part by one operator: a point of the R chart and of the interaction.
struct StudyCell {
    int part = 0, operators = 0; ///< places in the design's lists
    int count = 0;
    double mean = 0, range = 0, deviation = 0; ///< deviation: about the mean, n - 1; 0 for one
};

struct StudyMean {
    int place = 0; ///< of the part or operator in the design's list
    int count = 0;
    double mean = 0;
};

/// What charts of one quantity show.
struct QuantitySummary {
    QString name, unit; ///< "m", "kg"
    double mean = 0, meanRange = 0;
    std::vector<StudyMean> parts, operators; ///< those that were measured
    std::vector<StudyCell> cells;            ///< by part, then operator
    /// Limits of the ranges, (1 +- 3 d3/d2) meanRange, not below 0 (Montgomery, Introduction to Statistical
    /// Quality Control, section 6.2); none where cells hold single measurements or differ in number.
    std::optional<double> rangeLower, rangeUpper;
};

/// What a gauge study comes to.
struct GaugeResult {
    GaugeStudy study;                        ///< of the quantities that all measurements have, and jointly
    std::vector<QuantitySummary> quantities; ///< in the order of study.values
};

/// Of what counts; pure. Errors: BadInput where no quantity was determined in all measurements, or in several
/// units, and as studyGauge() has.
[[nodiscard]] Expected<GaugeResult> gaugeResult(const KeptStudy& study);

/// Readings of the quantity that a type-1 or linearity study is about, in the order in which they were made,
/// each beside what its part is; in the unit of the measurements.
struct ReferencedReadings {
    std::vector<double> references, values;
    QString unit;
    std::optional<MechanicalQuantity> quantity; ///< where that unit is SI
};
/// BadInput where a squeeze did not determine that quantity, a reference is no number, nothing counts, or the
/// readings are in several units.
[[nodiscard]] Expected<ReferencedReadings> referencedReadings(const KeptStudy& study);

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
