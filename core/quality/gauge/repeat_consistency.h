// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_layout.h"

namespace gripscope {

/// What repeats scatter beside what the squeezes state of themselves.
struct RepeatConsistency {
    double chiSquared = 0; ///< sum over cells of (y - weighted mean)^2 / u^2
    double degreesOfFreedom = 0;
    double above = 1, below = 1; ///< P(chi-squared larger), P(smaller) if the statements are true
    double ratio = 0;            ///< sqrt(chiSquared / degreesOfFreedom): Birge's ratio
    double statedDeviation = 0;  ///< root mean square of the standard uncertainties
};

/// Within each combination of part, operator and station the values differ by their own standard
/// uncertainties u alone if these are complete; then chiSquared is chi-squared (Birge 1932, Physical Review
/// 40; Cochran 1954, Biometrics 10). Assumes errors that are independent from squeeze to squeeze: what is
/// common to all (a sensor's calibration) belongs in u but does not scatter, so a ratio below 1 need not be
/// wrong. Nothing where nothing was repeated. Errors: BadInput for an uncertainty that is not above 0.
[[nodiscard]] Expected<std::optional<RepeatConsistency>>
repeatConsistency(const GaugeLayout& layout, const Eigen::VectorXd& values,
                  const Eigen::VectorXd& standardUncertainty);

} // namespace gripscope
