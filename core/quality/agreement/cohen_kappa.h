// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace gripscope {

/// Two verdicts on one part: classes by number.
struct VerdictPair {
    int part = 0, first = 0, second = 0;
};

struct CohenKappa {
    std::size_t pairs = 0;
    std::optional<double> agreement; ///< p_o; nothing without pairs
    /// Nothing where both gave all parts the same class: then there is no agreement beyond chance to see.
    std::optional<double> value;
    /// Nothing for a single part, and for full agreement, where the formula knows no error.
    std::optional<double> standardError;
};

/// Chance-corrected agreement of two raters, unweighted:
///     kappa = (p_o - p_e) / (1 - p_e)
/// p_o the share of pairs with the same class, p_e = sum_c p_c q_c by the shares of each rater (Cohen, A
/// coefficient of agreement for nominal scales, Educational and Psychological Measurement 20, 1960).
/// Standard error by the delta method, for large samples,
///     sqrt(sum over parts of (sum over the part's pairs of u)^2) / N
///     u_ij = ((1[i = j] - p_o) (1 - p_e) - (1 - p_o) (q_i + p_j - 2 p_e)) / (1 - p_e)^2
/// which with one pair a part is that of Fleiss, Cohen and Everitt (Psychological Bulletin 72, 1969), and
/// with several counts the parts, not the pairs, which are alike within a part. Pairs of a part stand
/// together; classes are 0 to `classes` - 1.
[[nodiscard]] CohenKappa cohenKappa(std::span<const VerdictPair> pairs, int classes);

} // namespace gripscope
