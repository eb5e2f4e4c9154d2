// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <chrono>
#include <future>
#include <optional>

namespace gripscope {

template <typename T>
[[nodiscard]] bool isReady(const std::future<T>& future)
{
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// identify() in the thread pool, on a copy of its own: the owner polls, and may go away while the work runs.
class IdentificationTask {
public:
    void start(Recording recording, IdentificationOptions options);
    [[nodiscard]] bool running() const { return m_future.valid(); }
    /// The answer, once: empty while the work runs or when there is none.
    [[nodiscard]] std::optional<Identification> take();
    /// Whatever is being worked out is no longer wanted.
    void forget() { m_future = {}; }

private:
    std::future<Identification> m_future;
};

} // namespace gripscope
