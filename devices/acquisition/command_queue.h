// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_port.h"
#include "devices/protocol/codec.h"

#include <chrono>
#include <deque>
#include <optional>

namespace gripscope {

/// Which command goes out next, and again when no answer came. Not a thread and not guarded: its owner sees
/// to both.
///
/// Commands go one after another, each when the one before was answered; uploads may run up to `uploadWindow`
/// ahead. A command without an answer is sent again after `patience`; the protocol makes repeats harmless.
/// Stop throws everything else away and goes first.
class CommandQueue {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t uploadWindow = 8;
    static constexpr std::chrono::milliseconds patience{100};
    static constexpr std::chrono::milliseconds stopPatience{20};
    static constexpr int attempts = 10; ///< a second in all
    static constexpr int stopAttempts = 50;

    /// What became of a command: its result, or nothing when no answer came at all.
    struct Outcome {
        protocol::CommandBody body;
        std::optional<protocol::CommandResult> result;
        std::uint32_t detail = 0;
    };

    void push(protocol::CommandBody body);
    void stop();
    void clear() { m_entries.clear(); }

    /// What to write now, if anything; counted as sent.
    [[nodiscard]] std::optional<protocol::Report> next(Clock::time_point now);
    /// When next() may have something though nothing else happens; far away when there is nothing to wait
    /// for.
    [[nodiscard]] Clock::time_point wakeAt() const;
    /// The command that this answers, taken out; nothing for an answer nobody waits for.
    [[nodiscard]] std::optional<Outcome> acknowledge(const protocol::Acknowledgement& answer);
    /// A command whose attempts are used up, taken out.
    [[nodiscard]] std::optional<Outcome> expired(Clock::time_point now);
    /// A heartbeat, which is neither queued nor repeated.
    [[nodiscard]] protocol::Report heartbeat();

    [[nodiscard]] bool empty() const { return m_entries.empty(); }
    [[nodiscard]] bool stopping() const;
    /// How many were sent, repeated, answered, refused and given up, and the heartbeats.
    void fill(LinkCounters& counters) const;

private:
    struct Entry {
        protocol::Command command;
        Clock::time_point sent;
        int timesSent = 0;
    };
    [[nodiscard]] static bool isStop(const Entry& entry);
    [[nodiscard]] static bool isUpload(const Entry& entry);
    [[nodiscard]] static Clock::duration patienceFor(const Entry& entry);
    [[nodiscard]] static int attemptsFor(const Entry& entry);

    std::deque<Entry> m_entries; ///< unanswered ones, in order
    std::uint16_t m_lastNumber = 0;
    std::uint64_t m_sent = 0, m_repeated = 0, m_answered = 0, m_refused = 0, m_unanswered = 0,
                  m_heartbeats = 0;
};

} // namespace gripscope
