// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/hid/hid_discovery.h"

#include <memory>

namespace gripscope {

/// Which HID devices there are, kept up to date by what the system tells of arrivals, removals and changes of
/// permission. The list is read when there was such news, and a few times shortly after it (a node may be
/// told of before it can be opened), never otherwise. All of it happens on a thread of its own, which sleeps
/// until there is news; any thread may ask, and no call waits.
class HidWatcher {
public:
    struct Snapshot {
        std::uint64_t revision = 0; ///< one more with each change; 0: the list was not read yet
        std::vector<HidNode> nodes;
    };

    HidWatcher();
    ~HidWatcher();
    HidWatcher(const HidWatcher&) = delete;
    HidWatcher& operator=(const HidWatcher&) = delete;

    [[nodiscard]] std::uint64_t revision() const;
    [[nodiscard]] Snapshot snapshot() const;

private:
    struct Shared;
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
