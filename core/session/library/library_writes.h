// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/library_service.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

/// Rows that are being written while the work goes on; the library writes them in the order they were given.
class LibraryWrites {
public:
    explicit LibraryWrites(LibraryService& library) : m_library(&library) {}

    void add(std::function<Expected<void>(Library&)> work)
    {
        m_writes.push_back(m_library->run<void>(std::move(work)));
    }
    [[nodiscard]] bool busy() const { return !m_writes.empty(); }
    /// The first error that came in, once.
    [[nodiscard]] std::optional<Error> poll()
    {
        std::optional<Error> error;
        const auto done = [&error](Pending<Expected<void>>& write) {
            const std::optional<Expected<void>> written = write.take();
            if (written && !*written && !error)
                error = written->error();
            return written.has_value();
        };
        m_writes.erase(std::remove_if(m_writes.begin(), m_writes.end(), done), m_writes.end());
        return error;
    }

private:
    LibraryService* m_library;
    std::vector<Pending<Expected<void>>> m_writes;
};

} // namespace gripscope
