// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace gripscope {

/// Round numbers (1, 2 or 5 times a power of ten apart) from `low` to `high`, at most `most` of them.
struct AxisTicks {
    std::vector<double> values;
    double step = 0;
    [[nodiscard]] QString
    label(double value) const; ///< with the decimals the step needs, and a true minus sign
};
[[nodiscard]] AxisTicks roundTicks(double low, double high, int most);
/// For a low plot from -half to half with three numbers: the largest round number that is not above `half`,
/// at least two thirds of it.
[[nodiscard]] double symmetricStep(double half);
/// Decimals that multiples of `step` need, at most 9.
[[nodiscard]] int decimalsOf(double step);

struct AxisRange {
    double low = 0, high = 1;
    [[nodiscard]] double span() const { return high - low; }
};
/// The range between round numbers that holds `low` to `high` with a little air; never empty: at least
/// `leastSpan` wide.
[[nodiscard]] AxisRange roundRange(double low, double high, double leastSpan);

} // namespace gripscope
