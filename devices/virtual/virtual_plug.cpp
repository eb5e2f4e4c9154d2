// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_plug.h"

#include <algorithm>
#include <mutex>

namespace gripscope::virtual_plug {

namespace {

struct Unplugged {
    VirtualAddress address;
    Clock::time_point back;
    Past past;
};

struct Memory {
    std::mutex mutex;
    std::vector<Unplugged> grippers;

    std::vector<Unplugged>::iterator find(const VirtualAddress& address)
    {
        return std::find_if(grippers.begin(), grippers.end(),
                            [&](const Unplugged& gripper) { return gripper.address == address; });
    }
};

Memory& memory()
{
    static Memory instance;
    return instance;
}

} // namespace

void unplug(const VirtualAddress& address, Clock::time_point back, const Past& past)
{
    Memory& known = memory();
    const std::lock_guard lock(known.mutex);
    const auto found = known.find(address);
    if (found == known.grippers.end())
        known.grippers.push_back({address, back, past});
    else
        *found = {address, back, past};
}

bool comesBack(const VirtualAddress& address)
{
    Memory& known = memory();
    const std::lock_guard lock(known.mutex);
    return known.find(address) != known.grippers.end();
}

bool isIn(const VirtualAddress& address)
{
    Memory& known = memory();
    const std::lock_guard lock(known.mutex);
    const auto found = known.find(address);
    return found == known.grippers.end() || Clock::now() >= found->back;
}

std::optional<Past> plugIn(const VirtualAddress& address)
{
    Memory& known = memory();
    const std::lock_guard lock(known.mutex);
    const auto found = known.find(address);
    if (found == known.grippers.end())
        return Past{};
    const Clock::time_point now = Clock::now();
    if (now < found->back)
        return std::nullopt;
    const double since_s = std::chrono::duration<double>(now - found->back).count() * address.speed;
    const Past past{found->past.faults_s + since_s, found->past.squeezes};
    known.grippers.erase(found);
    return past;
}

} // namespace gripscope::virtual_plug
