// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/session/identification_task.h"

#include <functional>
#include <future>
#include <memory>
#include <utility>

namespace gripscope {

/// One answer of the library that is being waited for by polling. Going away before it comes is fine: the
/// work is done all the same, and nobody is told.
class LibraryAnswer {
public:
    template <typename T>
    void await(std::future<Expected<T>> future, std::function<void(Expected<T>)> done)
    {
        auto shared = std::make_shared<std::future<Expected<T>>>(std::move(future));
        m_ready = [shared] { return isReady(*shared); };
        m_tell = [shared, done = std::move(done)] { done(shared->get()); };
    }
    [[nodiscard]] bool waiting() const { return static_cast<bool>(m_ready); }
    void forget()
    {
        m_ready = nullptr;
        m_tell = nullptr;
    }
    /// Tells, once, when the answer is there. True when it told.
    bool poll()
    {
        if (!m_ready || !m_ready())
            return false;
        const std::function<void()> tell = std::exchange(m_tell, nullptr);
        m_ready = nullptr;
        tell();
        return true;
    }

private:
    std::function<bool()> m_ready;
    std::function<void()> m_tell;
};

} // namespace gripscope
