// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_button.h"

#include <atomic>
#include <chrono>

namespace gripscope::virtual_button {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds held{100}; ///< as long as a finger stays on a button
std::atomic<Clock::rep> upAgain{0};

} // namespace

void press()
{
    upAgain = (Clock::now() + held).time_since_epoch().count();
}

bool down()
{
    const Clock::rep until = upAgain.load(std::memory_order_relaxed);
    return until != 0 && Clock::now().time_since_epoch().count() < until;
}

} // namespace gripscope::virtual_button
