// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_guest.h"
#include "core/library/link/plant_status.h"

#include <chrono>
#include <memory>
#include <thread>

namespace gripscope {

class SharedLink;

struct PlantLinkOptions {
    QString station; ///< a file
    QString server;  ///< LibraryLocation
    std::chrono::milliseconds every{2000};
    /// While it cannot be reached it is tried less and less often, each time at a moment of its own: the
    /// stations of a plant are not to come all at once when their server is back.
    std::chrono::milliseconds retryMost{30'000};
    /// A server that takes so long for one step is hung up on. In a step, the other stations may be waited
    /// for, and 200 transactions are written.
    std::chrono::milliseconds patience{60'000};
};
/// Usage: what is not a station's file and a server, in words.
[[nodiscard]] Expected<void> checkOptions(const PlantLinkOptions& options);

/// Keeps a station's library and its plant's server in step: one thread brings and fetches, step by step
/// (Library::exchangeWith()), and may wait for the network; another counts what waits, and ends what waits
/// too long. Nobody waits for either. Each has a connection of its own to the station's file, whose writers
/// wait for it no longer than for what comes from the server to be written.
class PlantLink {
public:
    explicit PlantLink(const PlantLinkOptions& options);
    ~PlantLink(); ///< as end(), with milliseconds
    PlantLink(const PlantLink&) = delete;
    PlantLink& operator=(const PlantLink&) = delete;

    [[nodiscard]] PlantStatus status() const;
    [[nodiscard]] qint64 typesTaken() const; ///< of status(), often asked for
    /// Where it takes longer, it ends by itself later. True: it is over.
    bool end(std::chrono::milliseconds patience);
    /// For the station's LibraryService; lives as long as somebody has it.
    [[nodiscard]] std::shared_ptr<LibraryGuest> guest() const;

private:
    std::shared_ptr<SharedLink> m_state;
    std::thread m_exchange, m_watch;
};

} // namespace gripscope
