// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

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

/// What is left of a wait. A computer that stood still meanwhile, as a virtual one does that is paused, kept
/// test and tested from running alike: of the time between two looks a second counts at most.
class PatienceLeft {
public:
    explicit PatienceLeft(std::chrono::milliseconds atMost = patience) : m_left(atMost) {}
    [[nodiscard]] bool isOver()
    {
        const auto now = Clock::now();
        m_left -= std::min<Clock::duration>(now - std::exchange(m_looked, now), std::chrono::seconds(1));
        return m_left < Clock::duration::zero();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::duration m_left;
    Clock::time_point m_looked = Clock::now();
};

} // namespace gripscope::test
