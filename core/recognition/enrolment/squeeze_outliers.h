// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/recognition/types/type_model.h"

#include <QString>

#include <vector>

namespace gripscope {

struct OutlierOptions {
    /// Share of enrolments without any outlier in which one is found all the same.
    double falseAlarm = 0.05;
};

/// A squeeze that lies away from the others of its type.
struct SqueezeOutlier {
    std::size_t index = 0; ///< among all squeezes
    double deviations = 0; ///< distance from the others in their standard deviations
    double chance = 1;     ///< share of enrolments without outliers that have a squeeze as far out
    int parameter =
        -1;         ///< the TypeQuantity (0, 1, 2: m, b, k) that stands out alone; -1: only all together do
    Finding reason; ///< "Stiffness is 8 % above the others, 5.2 of their standard deviations."
};

/// The squeezes of `type` that do not go with the others of it, the farthest first.
///
/// In spaceOf(squeezes). Each squeeze is held against the type without it: D^2 by the F distribution of the
/// predictive gate, and each quantity (m, b and k) by Student's t, which needs fewer squeezes; the
/// probability is 2 min(p_D, p min(p_m, p_b, p_k)). The least probable is taken out, and so on for up to a
/// third of the squeezes (5 at most). Outliers are all that were taken out up to the last whose probability
/// was below `falseAlarm` / (squeezes left * steps), so that two that hide each other are found; by
/// Bonferroni's inequality the false alarms of the whole enrolment stay at or below `falseAlarm`. (Caroni and
/// Prescott, Sequential application of Wilks's multivariate outlier test, Applied Statistics 1992.) Other
/// types only lend their scatter, up to 30 squeezes of each. Nothing is found among fewer than 3 squeezes,
/// nor where nothing is known of how squeezes differ.
[[nodiscard]] std::vector<SqueezeOutlier> findOutliers(const std::vector<TypeSqueeze>& squeezes,
                                                       const QString& type,
                                                       const OutlierOptions& options = {});

} // namespace gripscope
