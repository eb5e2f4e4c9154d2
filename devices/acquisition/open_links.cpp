// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/open_links.h"

#include "devices/acquisition/device_link.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace gripscope {

namespace {

struct Links {
    std::mutex mutex;
    std::vector<std::weak_ptr<DeviceLink>> open;
};

Links& links()
{
    static Links all;
    return all;
}

} // namespace

void addOpenLink(const std::shared_ptr<DeviceLink>& link)
{
    const std::lock_guard lock(links().mutex);
    std::erase_if(links().open, [](const std::weak_ptr<DeviceLink>& one) { return one.expired(); });
    links().open.push_back(link);
}

void stopOpenLinks() noexcept
{
    const std::lock_guard lock(links().mutex);
    for (const std::weak_ptr<DeviceLink>& one : links().open)
        if (const auto link = one.lock())
            link->stop();
}

} // namespace gripscope
