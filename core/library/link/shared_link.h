// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/exchange/library_exchange.h"
#include "core/library/library_guest.h"
#include "core/library/link/plant_link.h"
#include "core/library/sql/hangup.h"

#include <QDateTime>

#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

namespace gripscope {

/// What a station remembers of its plant's server, so that a program that starts without the network can
/// tell what waits. Only told to people: what is brought follows from what the server has.
struct LinkNote {
    QString server;        ///< its address, without a password
    QDateTime lastReached; ///< UTC
    DeliveredLinks delivered;
    friend bool operator==(const LinkNote&, const LinkNote&) = default;
};

/// Beside the library.
[[nodiscard]] QString linkNoteFile(const QString& library);
/// Nothing where there is none of this server, or none that can be read.
[[nodiscard]] std::optional<LinkNote> readLinkNote(const QString& file, const QString& server);
/// All of it or nothing, whatever ends the program. StorageFailed.
[[nodiscard]] Expected<void> writeLinkNote(const QString& file, const LinkNote& note);

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

/// Brings and fetches until the link ends; may wait for the network.
void exchangeUntilEnd(SharedLink& state);

/// Counts what waits, notes how far the server is, and hangs up on a server that takes too long, until the
/// link ends; never waits for the network.
void watchUntilEnd(SharedLink& state);

} // namespace gripscope
