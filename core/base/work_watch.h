// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

namespace gripscope {

/// Between a computation that takes long and whoever waits for it, from any thread: the one says how far it
/// is, the other may stop it.
class WorkWatch {
public:
    void stop() { m_stopped = true; }
    [[nodiscard]] bool stopped() const { return m_stopped; }
    void setShare(double done) { m_share = done; }
    [[nodiscard]] double share() const { return m_share; } ///< 0 to 1; stays at 0 where it cannot be told

private:
    std::atomic<bool> m_stopped{false};
    std::atomic<double> m_share{0};
};

/// Null: nobody watches.
[[nodiscard]] inline bool isStopped(const std::shared_ptr<WorkWatch>& watch)
{
    return watch && watch->stopped();
}

} // namespace gripscope
