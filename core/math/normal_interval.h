// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// Half a 95 % interval of a normal variable in its standard deviations: the quantile of 97.5 %.
inline constexpr double normal95 = 1.959963984540054;

} // namespace gripscope
