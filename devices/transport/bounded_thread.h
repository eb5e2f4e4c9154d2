// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace gripscope {

/// A thread whose end is waited for only so long. One that is stuck in a system call is left behind; what it
/// uses must therefore belong to its body (captured shared pointers).
class BoundedThread {
public:
    BoundedThread() = default;
    template <typename Body>
    explicit BoundedThread(Body body) : m_end(std::make_shared<End>())
    {
        m_thread = std::thread([end = m_end, work = std::move(body)]() mutable {
            work();
            {
                const auto spent = std::move(work); // before the end is told: nothing of it is left then
            }
            const std::lock_guard lock(end->mutex);
            end->reached = true;
            end->condition.notify_all();
        });
    }
    BoundedThread(BoundedThread&&) = default;
    BoundedThread& operator=(BoundedThread&&) = default;
    ~BoundedThread() { finishBy(std::chrono::steady_clock::now()); }

    /// Waits for the end until `deadline`; false: it was left behind.
    bool finishBy(std::chrono::steady_clock::time_point deadline)
    {
        if (!m_thread.joinable())
            return true;
        std::unique_lock lock(m_end->mutex);
        const bool reached = m_end->condition.wait_until(lock, deadline, [&] { return m_end->reached; });
        lock.unlock();
        reached ? m_thread.join() : m_thread.detach();
        return reached;
    }

private:
    struct End {
        std::mutex mutex;
        std::condition_variable condition;
        bool reached = false;
    };
    std::shared_ptr<End> m_end;
    std::thread m_thread;
};

} // namespace gripscope
