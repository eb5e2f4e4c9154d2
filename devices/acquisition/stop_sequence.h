// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/acquisition/link_limits.h"
#include "devices/protocol/report.h"

namespace gripscope {

/// Stops a gripper and sees whether it obeyed. No thread, no clock.
///
///     begin() -> Stop, Stop, Stop -> silence for the watchdog's time and its margin -> nothing more
///
/// While it is engaged nothing else may be sent, no heartbeat above all: a gripper that does not obey is left
/// to its own watchdog. Obeyed: within `obeyWithin` the stream says disarmed, and three samples in a row have
/// less than a tenth of the force there was, counted from the force at rest. A writer that is kept waiting by
/// other programs is granted a moment, one that hangs in its write is not.
class StopSequence {
public:
    using Clock = std::chrono::steady_clock;
    using Time = Clock::time_point;

    struct Begin {
        protocol::Report report{}; ///< what is sent
        bool armed = false;        ///< what the device said last
        double force = 0;          ///< largest distance from rest of late, in the channel's unit
        double floor = 0;          ///< below it a force cannot be told from none
        std::chrono::milliseconds watchdog{0};
        bool samplesCome = true;  ///< false: only while a squeeze runs; without one there are none to confirm
        bool forceMatters = true; ///< false: it was not armed, what its sensor shows is somebody's hand
    };
    StopSequence() = default;
    explicit StopSequence(const LinkLimits& limits) : m_limits(limits) {}

    void begin(const Begin& begin, Time now);
    /// From begin() until the silence is over.
    [[nodiscard]] bool engaged(Time now) const;
    /// The next Stop, when it is due; counted as sent.
    [[nodiscard]] std::optional<protocol::Report> next(Time now);
    [[nodiscard]] Time wakeAt() const; ///< when next() or engaged() changes; far away where nothing does
    [[nodiscard]] bool allSent() const { return m_sent >= m_limits.stops; }
    [[nodiscard]] bool sentBefore() const { return m_sent > 1; }

    // What the device says, as it is read.
    void takeArmed(bool armed, Time now);
    void takeForce(double distanceFromRest, Time now);
    /// Everything that came before `time` was read.
    void heard(Time time);

    /// Waiting only until `obeyWithin` is over and what came until then was read.
    [[nodiscard]] StopState state(Time now) const;

private:
    void judge(Time now);
    [[nodiscard]] Time deadline() const;
    static constexpr double shareLeft = 0.1;
    static constexpr int samplesInRow = 3; ///< one alone may be noise

    LinkLimits m_limits;
    Begin m_begin;
    std::optional<Time> m_began, m_firstSent, m_obeyedAt;
    Time m_heard{}, m_lastSent{};
    int m_sent = 0;
    bool m_armed = false;
    int m_relaxed = 0; ///< samples in a row
};

} // namespace gripscope
