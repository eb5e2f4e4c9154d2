// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/acquisition/link_limits.h"
#include "devices/protocol/codec.h"

#include <array>
#include <chrono>
#include <deque>
#include <optional>

namespace gripscope {

/// Which command goes out next, and again when no answer came. Not a thread and not guarded: its owner sees
/// to both.
///
/// Commands go one after another, each when the one before was answered; uploads may run up to `uploadWindow`
/// ahead. A command without an answer is sent again after `patience`; the protocol makes repeats harmless
/// (Arm's since 1.1). Stop is sent by its own rule (StopSequence); here it throws everything else away.
class CommandQueue {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t uploadWindow = 8;
    static constexpr std::chrono::milliseconds patience{100};
    /// Below the watchdog's time: an Arm whose answer was lost is asked again while it still holds.
    static constexpr std::chrono::milliseconds armPatience{30};

    /// What became of a command: its result, or nothing when no answer came at all.
    struct Outcome {
        protocol::CommandBody body;
        std::optional<protocol::CommandResult> result;
        std::uint32_t detail = 0;
        Clock::duration waited{}; ///< for an answer that did not come
    };

    CommandQueue() = default;
    /// `lastNumber`: so that two programs hardly use the same numbers. `repeatsArm`: the device knows that an
    /// Arm repeated is the same Arm. `attempts`: so often a command is sent in all.
    CommandQueue(std::uint16_t lastNumber, bool repeatsArm, int attempts = LinkLimits{}.attempts)
        : m_lastNumber(lastNumber), m_repeatsArm(repeatsArm), m_attempts(attempts)
    {
    }

    void push(protocol::CommandBody body);
    /// Throws away what waits, and gives the bytes of a Stop or Disarm, which its owner sends.
    [[nodiscard]] protocol::Report halt(protocol::CommandBody body);
    void countHalt(bool again) { ++(again ? m_repeated : m_sent); }
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

    /// Whether this program sent the command that this answers, of late. Else another one speaks to the
    /// gripper.
    [[nodiscard]] bool sentHere(const protocol::Acknowledgement& answer) const;

    [[nodiscard]] bool empty() const { return m_entries.empty(); }
    /// How many were sent, repeated, answered, refused and given up, and the heartbeats.
    void fill(LinkCounters& counters) const;

private:
    struct Entry {
        protocol::Command command;
        Clock::time_point sent;
        int timesSent = 0;
    };
    [[nodiscard]] static bool isArm(const Entry& entry);
    [[nodiscard]] static bool isUpload(const Entry& entry);
    [[nodiscard]] static Clock::duration patienceFor(const Entry& entry);
    [[nodiscard]] int attemptsFor(const Entry& entry) const;
    [[nodiscard]] protocol::Command number(protocol::CommandBody body);

    std::deque<Entry> m_entries;             ///< unanswered ones, in order
    std::optional<protocol::Command> m_halt; ///< until it is answered
    std::uint16_t m_lastNumber = 0;
    bool m_repeatsArm = true;
    int m_attempts = LinkLimits{}.attempts;
    std::array<protocol::ReportId, 1024> m_numbered{}; ///< what the last numbers were given to, a ring
    std::size_t m_numberedCount = 0;
    std::uint64_t m_sent = 0, m_repeated = 0, m_answered = 0, m_refused = 0, m_unanswered = 0,
                  m_heartbeats = 0;
};

} // namespace gripscope
