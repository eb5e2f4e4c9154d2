// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QStringList>

#include <array>
#include <vector>

namespace gripscope {

/// What one effect (the id of its line in the uncertainty budget) has in the variances of m, b and k, 0 to 1.
struct ErrorShare {
    QString effect;
    std::array<double, 3> share{};
};

struct ImprovementFacts {
    std::array<double, 3> relativeHalfWidths{}; ///< of the 95 % intervals of m, b, k
    double naturalFrequency_Hz = 0;
    std::vector<ErrorShare> shares; ///< empty: noise is all that is known
};

/// What would make m, b and k better, the worst first: at most three sentences, each with what to do. Effects
/// count that hold at least half of a parameter's variance.
[[nodiscard]] QStringList improvementAdvice(const ImprovementFacts& facts);

/// For the recommended estimate. Nothing when the measurement is invalid: the failed checks say what to do
/// then; nothing without error bars.
[[nodiscard]] QStringList improvementAdvice(const Identification& identification);

} // namespace gripscope
