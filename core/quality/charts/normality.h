// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/quality/charts/subgroups.h"

#include <span>

namespace gripscope {

struct NormalityTest {
    double statistic = 0; ///< A^2
    double adjusted = 0;  ///< A^2 (1 + 0.75/n + 2.25/n^2)
    double p = 1;         ///< not below 3.7e-24, where the formula ends
};

/// Anderson and Darling's test of normal values, mean and standard deviation from the values:
///     A^2 = -n - (1/n) sum (2i - 1) [log Phi(z_i) + log(1 - Phi(z_(n+1-i)))],  z sorted,
/// and p by the formula of D'Agostino and Stephens (Goodness-of-Fit Techniques, 1986, table 4.9). Assumes
/// independent values. BadInput: fewer than 8 values, or values that do not vary.
[[nodiscard]] Expected<NormalityTest> testNormality(std::span<const double> values);
/// The same of values that are sorted already, ascending, and their summary.
[[nodiscard]] Expected<NormalityTest> testNormality(std::span<const double> sorted,
                                                    const SubgroupSummary& summary);

} // namespace gripscope
