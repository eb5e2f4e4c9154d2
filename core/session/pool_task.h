// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QThreadPool>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <utility>

namespace gripscope {

template <typename T>
[[nodiscard]] bool isReady(const std::future<T>& future)
{
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// A computation in the thread pool: the owner polls, and may go away while the work runs.
template <typename T>
class PoolTask {
public:
    /// `work` owns all that it reads.
    void start(std::function<T()> work)
    {
        // A promise rather than std::async: a future of the latter would wait in its destructor.
        auto promise = std::make_shared<std::promise<T>>();
        m_future = promise->get_future();
        QThreadPool::globalInstance()->start(
            [promise, work = std::move(work)] { promise->set_value(work()); });
    }
    [[nodiscard]] bool running() const { return m_future.valid(); }
    /// The answer, once: empty while the work runs or when there is none.
    [[nodiscard]] std::optional<T> take()
    {
        if (!isReady(m_future))
            return std::nullopt;
        return m_future.get(); // leaves the future empty
    }
    /// Whatever is being worked out is no longer wanted.
    void forget() { m_future = {}; }

private:
    std::future<T> m_future;
};

} // namespace gripscope
