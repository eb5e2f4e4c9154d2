// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_study.h"
#include "core/session/quality/kept_study.h"

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

} // namespace gripscope
