// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// Of the space of (ln m, ln b, ln k) that types are told apart in.
inline constexpr int dimensions = 3;

} // namespace gripscope
