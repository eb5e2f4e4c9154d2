// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/agreement/ratings.h"

namespace gripscope {

/// One class against all others.
struct ClassKappa {
    int verdict = 0;  ///< the class
    double share = 0; ///< of the verdicts, p
    std::optional<double> value, z;
};

struct FleissKappa {
    std::size_t parts = 0;   ///< with two verdicts at least; the others say nothing
    std::size_t ratings = 0; ///< on those
    /// Nothing where all verdicts are of one class: then there is no agreement beyond chance to see.
    std::optional<double> value;
    std::optional<double> standardError; ///< where there is no agreement beyond chance
    std::optional<double> z, p;          ///< of none, the upper tail: more than chance
    std::vector<ClassKappa> classes;     ///< those that occur
};

/// Chance-corrected agreement of any number of verdicts m_i on each of N parts:
///     kappa = (P - P_e) / (1 - P_e)
///     P = mean over parts of sum_c n_ic (n_ic - 1) / (m_i (m_i - 1))
///     P_e = sum_c p_c^2, p_c the mean over parts of n_ic / m_i
/// (Fleiss, Measuring nominal scale agreement among many raters, Psychological Bulletin 76, 1971; for unequal
/// m_i Gwet, Handbook of Inter-Rater Reliability, 2014). z = kappa / se, with the error under no agreement
///     se^2 = 2 (sum p^2 + (sum p^2)^2 - 2 sum p^3) / (1 - P_e)^2 sum_i 1 / (m_i (m_i - 1)) / N^2
/// of Fleiss, Nee and Landis (Psychological Bulletin 86, 1979), who have all m_i alike; 1971's own was wrong.
/// Verdicts of one rater on the same part count as those of different raters do.
[[nodiscard]] FleissKappa fleissKappa(const std::vector<Rating>& ratings, int classes);

} // namespace gripscope
