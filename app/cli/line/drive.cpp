// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/drive.h"

#include "devices/emergency/end_signals.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace gripscope::cli {

namespace {

std::atomic<bool> interruptNoted{false};

} // namespace

void catchInterrupts()
{
    static const EndSignals ending([] { interruptNoted = true; });
}

bool interrupted()
{
    return interruptNoted;
}

bool drive(const std::function<void()>& poll, const std::function<bool()>& done, double seconds)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!interrupted()) {
        poll();
        if (done())
            return true;
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return false;
}

} // namespace gripscope::cli
