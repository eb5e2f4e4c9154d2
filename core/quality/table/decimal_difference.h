// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace gripscope {

/// `a` - `b` of two numbers as they are written, rounded once, at the end: 1000000000000.4 and
/// 1000000000000.3 differ by 0.1, where doubles of them differ by 0.0999. Nothing where either has an
/// exponent, a sign and no digits, or more than 18 digits with the other's decimals: what doubles say is then
/// as good as anything.
[[nodiscard]] std::optional<double> decimalDifference(std::string_view a, std::string_view b);

} // namespace gripscope
