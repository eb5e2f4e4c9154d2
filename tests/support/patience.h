// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace gripscope::test {

/// How many times slower than `release` a program under sanitizers is at worst: an identification of friction
/// in three squeezes took 4 s, and 56 s with every check.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int slowerBySanitizers = 10;
#else
inline constexpr int slowerBySanitizers = 1;
#endif

/// Far longer than anything that a test awaits takes, so that a busy computer does not fail it; a program
/// that hangs still does. What comes is not waited for any longer. (In a file of its own, for programs that
/// check without Qt Test.)
inline constexpr int longEnough_ms = 60'000 * slowerBySanitizers;
inline constexpr std::chrono::milliseconds patience{longEnough_ms};

} // namespace gripscope::test
