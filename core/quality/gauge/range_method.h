// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/source_sums.h"

namespace gripscope {

/// Of the mean of `ranges` ranges of n values each:
///     d2* = sqrt(E[mean^2]) = sqrt(d2^2 + d3^2 / ranges)
/// (Duncan 1974, Quality Control and Industrial Statistics, table D3; the AIAG manual's appendix C), and the
/// degrees of freedom of a chi that has the same mean (Patnaik 1950, Biometrika 37), as many as mean / d2*
/// has.
struct MeanRange {
    double d2Star = 0, degreesOfFreedom = 0;
};

[[nodiscard]] MeanRange meanRange(int n, int ranges);

/// The average and range method (AIAG, Measurement Systems Analysis, 4th edition, chapter III): repeatability
/// from the mean range of the trials over d2*(trials, parts x operators), operators from the range of their
/// means less repeatability / (parts trials), parts from the range of their means over d2*(parts, 1), from
/// which, as in the manual, nothing is taken off. No interaction: it counts as part of all three. In the
/// form of sourceSums(): mean squares with their equivalent degrees of freedom.
/// Errors: Usage for a design that is not crossed, balanced and of parts and operators alone, for single
/// trials and more than 1000 parts.
[[nodiscard]] Expected<SourceSums> rangeSums(const GaugeLayout& layout, const Eigen::VectorXd& values);

} // namespace gripscope
