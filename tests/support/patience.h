// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace gripscope::test {

/// Far longer than anything that a test awaits takes, so that a busy computer does not fail it; a program
/// that hangs still does. What comes is not waited for any longer. (In a file of its own, for programs that
/// check without Qt Test.)
inline constexpr int longEnough_ms = 60'000;
inline constexpr std::chrono::milliseconds patience{longEnough_ms};

} // namespace gripscope::test
