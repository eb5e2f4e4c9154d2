// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace gripscope {

/// Asked to end (by Ctrl-C, a logout, a shutdown, a terminal that closes), the program stops every gripper
/// first, whatever its own threads are busy with, and then does what it was given to do. Asked a second time,
/// or still there three seconds later, it ends at once.
///
/// One at a time in a program; the signals' former actions come back with its end.
class EndSignals {
public:
    /// `then` is called from a thread of its own, once.
    explicit EndSignals(std::function<void()> then);
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
