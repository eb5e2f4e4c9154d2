// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/library/link/shared_link.h"

namespace gripscope {

/// The station's library as one thread of a link has it, as long as it may.
class StationHold {
public:
    StationHold(SharedLink& state, LinkThread thread) : m_state(state), m_thread(thread) {}
    ~StationHold() { close(); }
    StationHold(const StationHold&) = delete;
    StationHold& operator=(const StationHold&) = delete;

    [[nodiscard]] Expected<Library*> open()
    {
        if (m_library)
            return m_library.get();
        RETURN_IF_ERROR(m_state.holdStation(m_thread));
        Expected<std::unique_ptr<Library>> opened = Library::open(m_state.options().station);
        if (!opened) {
            close();
            return tl::unexpected(opened.error());
        }
        m_library = std::move(*opened);
        return m_library.get();
    }
    void close()
    {
        m_library.reset();
        m_state.letStationGo(m_thread);
    }

private:
    SharedLink& m_state;
    LinkThread m_thread;
    std::unique_ptr<Library> m_library;
};

} // namespace gripscope
