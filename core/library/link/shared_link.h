// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/exchange/library_exchange.h"
#include "core/library/library_guest.h"
#include "core/library/link/link_note.h"
#include "core/library/link/plant_link.h"
#include "core/library/sql/hangup.h"

#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace gripscope {

using LinkClock = std::chrono::steady_clock;
enum LinkThread { ExchangeThread, WatchThread };

/// What the threads of a link and who asks for it have in common.
class SharedLink : public LibraryGuest {
public:
    explicit SharedLink(const PlantLinkOptions& options);

    // For who has the link.
    [[nodiscard]] PlantStatus status() const;
    [[nodiscard]] qint64 typesTaken() const;
    void end(); ///< they are told to
    [[nodiscard]] bool hasEnded(std::chrono::milliseconds patience);
    void leave() override;
    void comeBack() override;

    // For its threads.
    [[nodiscard]] const PlantLinkOptions& options() const { return m_options; }
    [[nodiscard]] const std::shared_ptr<Hangup>& hangup() const { return m_hangup; }
    /// Waits so long, or for what is asked for; calls `letGo` where the station's file is needed alone.
    /// False: it is over.
    [[nodiscard]] bool await(std::chrono::milliseconds pause, const std::function<void()>& letGo);
    void noteEnd(); ///< of one of them
    /// StorageOpen: not now.
    [[nodiscard]] Expected<void> holdStation(LinkThread thread);
    void letStationGo(LinkThread thread);

    void beginStep();
    void endStep(const ExchangeStep& step);
    void endStep(const Error& error, bool reached);
    void hangUpWhatIsLate();
    /// What an earlier program knew, where this one knows nothing yet.
    void remember(const LinkNote& note);
    [[nodiscard]] std::optional<LinkNote> note() const; ///< nothing before it was ever reached
    void tellWaiting(qint64 inspections);

private:
    const PlantLinkOptions m_options;
    const std::shared_ptr<Hangup> m_hangup = std::make_shared<Hangup>();
    mutable std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_turn, m_quiet;
    bool m_ending = false, m_suspended = false;
    int m_running = 2;             ///< threads
    std::array<bool, 2> m_holds{}; ///< the station's file, by LinkThread
    PlantStatus m_known;
    std::optional<DeliveredLinks> m_delivered;
    std::optional<LinkClock::time_point> m_stepBegan;
};

} // namespace gripscope
