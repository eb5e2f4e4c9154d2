// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"

#include <Eigen/Core>
#include <QStringList>

#include <vector>

namespace gripscope {

/// The paper's appendix: 10 squeezes of each of 4 cans. "Units as printed": the paper names none.
struct PaperAppendix {
    QStringList object;         ///< A..D, one a row
    Eigen::MatrixXd parameters; ///< 40 x 3: m, b, k
    std::vector<double> bestFitPercent;
};
[[nodiscard]] const PaperAppendix& paperAppendix();

/// Seconds in one of the paper's units of time that turn its cans into plausible ones in SI: m stays, b is
/// divided by it, k by its square (A: 0.0396 kg, 43.0 N s/m, 9,990 N/m; natural frequency 80 Hz).
inline constexpr double paperTimeUnit_s = 0.0032;
[[nodiscard]] std::vector<TypeSqueeze> paperSqueezesAsPrinted();
[[nodiscard]] std::vector<TypeSqueeze> paperSqueezesInSi();

} // namespace gripscope
