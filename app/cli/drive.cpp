// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/drive.h"

#include <chrono>
#include <csignal>
#include <thread>

namespace gripscope::cli {

namespace {

volatile std::sig_atomic_t interruptNoted = 0;

void noteInterrupt(int)
{
    interruptNoted = 1;
}

} // namespace

void catchInterrupts()
{
    std::signal(SIGINT, noteInterrupt);
    std::signal(SIGTERM, noteInterrupt);
}

bool interrupted()
{
    return interruptNoted != 0;
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
