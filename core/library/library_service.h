// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/pending.h"
#include "core/library/library.h"
#include "core/library/library_guest.h"
#include "core/people/acting.h"

#include <functional>
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

    /// Runs `work` with the library on its thread. When the library cannot be opened, that error is the
    /// answer.
    template <typename T>
    [[nodiscard]] Pending<Expected<T>> run(std::function<Expected<T>(Library&)> work)
    {
        const Promise<Expected<T>> answer;
        post([answer, work = std::move(work)](Expected<Library*> library) {
            answer.give(library ? work(**library) : Expected<T>(tl::unexpected<Error>(library.error())));
        });
        return answer.pending();
    }

    /// Runs `work` on that thread while neither this service nor its guest has the library open: for what
    /// needs its file alone. What is asked for next opens it again.
    template <typename T>
    [[nodiscard]] Pending<Expected<T>> runClosed(std::function<Expected<T>(const Acting&)> work)
    {
        const Promise<Expected<T>> answer;
        postClosed([answer, work = std::move(work)](const Acting& acting) { answer.give(work(acting)); });
        return answer.pending();
    }

    [[nodiscard]] QString file() const;

    /// Who else has its file open; the last one that was named counts.
    void setGuest(std::weak_ptr<LibraryGuest> guest);

    /// Who asks for what is asked for from now on.
    void actAs(const Acting& acting);

private:
    void post(std::function<void(Expected<Library*>)> job);
    void postClosed(std::function<void(const Acting&)> job);
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
