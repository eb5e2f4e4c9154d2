// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/two_sided_interval.h"

#include <cstddef>
#include <optional>

namespace gripscope {

/// Confidence limits of a standard deviation, and of an index that has it below, from n normal values:
/// (n - 1) s^2 / sigma^2 is chi-square with n - 1 degrees of freedom.
///     sigma: s sqrt((n - 1) / chi^2_upper) to s sqrt((n - 1) / chi^2_lower)
///     Cg:    Cg sqrt(chi^2_lower / (n - 1)) to Cg sqrt(chi^2_upper / (n - 1))
/// Nothing for fewer than two values, or a value or deviation that is not finite.
[[nodiscard]] std::optional<TwoSidedInterval> deviationInterval(double deviation, std::size_t count,
                                                                double confidence);
[[nodiscard]] std::optional<TwoSidedInterval> capabilityInterval(double cg, std::size_t count,
                                                                 double confidence);

/// Confidence limits of Cgk = (a - |bias|) / (h sigma), h = sigmas / 2: sqrt(n) h Cgk as it is found is
/// Student's t with n - 1 degrees of freedom and the shift sqrt(n) h Cgk as it is (Chou, Owen and Borrego,
/// Lower confidence limits on process capability indices, Journal of Quality Technology 22, 1990; here both
/// limits, and Cgk may be negative). Exact where the sign of the bias is certain. Where it is not, |bias|
/// makes the index as it is found too small: the lower limit then holds more often than stated, the upper
/// one less often. With 95 % stated, 93 to 96 % hold in simulation for 5 to 50 values.
[[nodiscard]] std::optional<TwoSidedInterval> biasedCapabilityInterval(double cgk, double sigmas,
                                                                       std::size_t count, double confidence);

} // namespace gripscope
