// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/library_service.h"
#include "core/session/tasks/pool.h"

#include <QObject>
#include <QPointer>
#include <QThreadPool>

#include <functional>
#include <vector>

namespace gripscope {

/// What a page wants done without waiting for it: questions to the library, computations in a pool of their
/// own (the sessions' squeezes do not wait behind it). Polled on the screen's thread, where the answers are
/// told.
class Background {
public:
    /// `wake` is called on another thread when an answer has come, so that poll() need not wait for its turn.
    explicit Background(LibraryService& library, std::function<void()> wake = {})
        : m_library(&library), m_wake(std::move(wake))
    {
    }
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Asks the library on its own thread, and calls `done` on the screen's thread with the answer, unless
    /// `context` is gone by then.
    template <typename T>
    void ask(QObject* context, std::function<Expected<T>(Library&)> work,
             std::function<void(Expected<T>)> done)
    {
        await(context, m_library->run<T>(std::move(work)), std::move(done));
    }
    /// The same while this program does not have the library open (LibraryService::runClosed).
    template <typename T>
    void askClosed(QObject* context, std::function<Expected<T>(const Acting&)> work,
                   std::function<void(Expected<T>)> done)
    {
        await(context, m_library->runClosed<T>(std::move(work)), std::move(done));
    }
    /// Runs `work` (identification, clustering) in the pool, and `done` on the screen's thread.
    template <typename T>
    void compute(QObject* context, std::function<T()> work, std::function<void(T)> done)
    {
        await(context, inPool(std::move(work), m_pool), std::move(done));
    }
    /// Something is computed in the pool: the end of this would wait for it.
    [[nodiscard]] bool busy() const { return m_pool.activeThreadCount() > 0; }
    /// Tells the answers that have come.
    void poll();

private:
    struct Awaited {
        QPointer<QObject> context;
        bool bound = false; ///< to the life of `context`
        PendingCall call;
        [[nodiscard]] bool wanted() const { return !bound || !context.isNull(); }
    };
    template <typename T, typename Done>
    void await(QObject* context, Pending<T> pending, Done done)
    {
        pending.whenReady(m_wake);
        m_awaited.push_back({context, context != nullptr, PendingCall(std::move(pending), std::move(done))});
    }

    LibraryService* m_library;
    std::function<void()> m_wake;
    QThreadPool m_pool;
    std::vector<Awaited> m_awaited;
};

} // namespace gripscope
