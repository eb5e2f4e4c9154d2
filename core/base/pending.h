// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace gripscope {

template <typename T>
class Promise;

/// A value that is worked out on another thread: the library's, or one of a pool. Who wants it polls and
/// never waits; who goes away, or wants it no longer, is not told, and the work is done all the same. The
/// work says what went wrong by its value (Expected), not by an exception.
template <typename T>
class Pending {
public:
    Pending() = default;

    /// Asked for, and neither taken nor forgotten.
    [[nodiscard]] bool waiting() const { return m_answer != nullptr; }
    /// take() has something to give.
    [[nodiscard]] bool ready() const
    {
        if (!m_answer)
            return false;
        const std::lock_guard guard(m_answer->mutex);
        return m_answer->value.has_value();
    }
    /// The value, once; nothing while the work runs, and when there is none.
    [[nodiscard]] std::optional<T> take()
    {
        if (!ready())
            return std::nullopt;
        const auto answer = std::exchange(m_answer, nullptr);
        return std::move(answer->value);
    }
    /// The value, waited for: where there is no screen.
    [[nodiscard]] T get()
    {
        const auto answer = std::exchange(m_answer, nullptr);
        std::unique_lock lock(answer->mutex);
        answer->come.wait(lock, [&] { return answer->value.has_value(); });
        return std::move(*answer->value);
    }
    void forget() { m_answer = nullptr; }
    /// Calls `wake` once the value is there, on the thread that gives it, so that who polls need not wait for
    /// the next time; at once where it is there already. Only while waiting().
    void whenReady(const std::function<void()>& wake)
    {
        {
            const std::lock_guard guard(m_answer->mutex);
            if (!m_answer->value) {
                m_answer->wake = wake;
                return;
            }
        }
        if (wake)
            wake();
    }

private:
    friend class Promise<T>;
    struct Answer {
        std::mutex mutex;
        std::condition_variable come;
        std::optional<T> value;
        std::function<void()> wake;
    };
    std::shared_ptr<Answer> m_answer;
};

/// Gives a pending value, once, from any thread.
template <typename T>
class Promise {
public:
    [[nodiscard]] Pending<T> pending() const
    {
        Pending<T> pending;
        pending.m_answer = m_answer;
        return pending;
    }
    void give(T value) const
    {
        std::function<void()> wake;
        {
            const std::lock_guard guard(m_answer->mutex);
            m_answer->value = std::move(value);
            wake = std::move(m_answer->wake);
            m_answer->come.notify_all();
        }
        if (wake)
            wake();
    }

private:
    std::shared_ptr<typename Pending<T>::Answer> m_answer = std::make_shared<typename Pending<T>::Answer>();
};

/// A pending value and who is told of it: `then`, called with the value.
class PendingCall {
public:
    PendingCall() = default;
    template <typename T, typename Then>
    PendingCall(Pending<T> pending, Then then)
    {
        auto shared = std::make_shared<Pending<T>>(std::move(pending));
        m_ready = [shared] { return shared->ready(); };
        m_tell = [shared, then = std::move(then)] { then(*shared->take()); };
    }

    [[nodiscard]] bool waiting() const { return static_cast<bool>(m_ready); }
    [[nodiscard]] bool ready() const { return m_ready && m_ready(); }
    /// Tells, once, when the value is there; what is told may ask again. True when it told.
    bool poll()
    {
        if (!ready())
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
