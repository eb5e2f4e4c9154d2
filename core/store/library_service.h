// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/acting.h"
#include "core/store/library.h"

#include <functional>
#include <future>
#include <memory>

namespace gripscope {

/// The library behind a thread of its own, so that a screen never waits for the disk. Work is done in the
/// order it was asked for; the destructor finishes what is queued.
class LibraryService {
public:
    explicit LibraryService(QString file);
    ~LibraryService();
    LibraryService(const LibraryService&) = delete;
    LibraryService& operator=(const LibraryService&) = delete;

    /// Runs `work` with the library on its thread. When the library cannot be opened the future holds that
    /// error.
    template <typename T>
    [[nodiscard]] std::future<Expected<T>> run(std::function<Expected<T>(Library&)> work)
    {
        auto promise = std::make_shared<std::promise<Expected<T>>>();
        std::future<Expected<T>> future = promise->get_future();
        post([promise, work = std::move(work)](Expected<Library*> library) {
            promise->set_value(library ? work(**library)
                                       : Expected<T>(tl::unexpected<Error>(library.error())));
        });
        return future;
    }

    [[nodiscard]] QString file() const;

    /// Who asks for what is asked for from now on.
    void actAs(const Acting& acting);
    [[nodiscard]] Acting acting() const;

private:
    void post(std::function<void(Expected<Library*>)> job);
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
