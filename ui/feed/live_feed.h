// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/recursive/recursive_estimator.h"
#include "core/session/connection/connect_session.h"
#include "core/session/connection/gripper_port.h"
#include "ui/feed/live_history.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

/// m, b and k of the squeeze under way, after every sample: begins when the device reports that it moves, and
/// holds what it found when it stops, until the next squeeze. A lost sample is told to the estimator as such.
class LiveEstimate {
public:
    /// Another gripper: forgets everything.
    void reset(double sampleTime_s, ForceHold hold, double forceLag_s);
    /// The lag that was measured of this gripper; holds from the next squeeze on.
    void setForceLag(double forceLag_s) { m_options.lag_s = forceLag_s; }
    void append(const std::vector<Sample>& samples);

    [[nodiscard]] bool following() const { return m_moving; }
    /// Of the squeeze under way or of the last one; nothing before the first.
    [[nodiscard]] std::optional<RecursiveState> state() const;

private:
    void take(const Sample& sample);

    RecursiveOptions m_options;
    std::optional<RecursiveEstimator> m_estimator;
    std::uint64_t m_lastSequence = 0;
    bool m_moving = false;
};

/// The force that the gripper was asked for, sample by sample. Force i of an excitation stands from the i-th
/// sample on that says that it moves (devices/PROTOCOL.md, section 6), so it is placed by the device's own
/// sample numbers. Nothing is known of what this program did not start, and of a squeeze whose first sample
/// was lost: its forces could stand in the wrong place.
class CommandedForce {
public:
    /// One force for each sample, in N.
    [[nodiscard]] std::vector<std::optional<double>> follow(const std::vector<Sample>& samples,
                                                            const SafetyGate::Started& started);
    /// Another link: its gate counts from the beginning, and so do its samples.
    void reset() { *this = {}; }

private:
    void begin(const Sample& first, const SafetyGate::Started& started);

    std::uint64_t m_taken = 0;         ///< number of the excitation that was seen to begin
    std::vector<double> m_force_N;     ///< while it moves; empty: not known
    std::uint64_t m_firstSequence = 0; ///< of the sample with force 0
    std::optional<Sample> m_newest;
};

/// What pages show of a gripper that is connected: its samples on one axis of time, the force it was asked
/// for beside each, and m, b and k of the squeeze under way.
class LiveFeed {
public:
    /// A gripper was opened. One that is `back` goes on where it left off, with a gap for the time without
    /// it; any other starts anew.
    void open(const ConnectSession& connection, bool back);
    void take(const std::vector<Sample>& samples, ConnectSession& connection);
    void setForceLag(double lag_s) { m_estimate.setForceLag(lag_s); }

    [[nodiscard]] const LiveHistory& history() const { return m_history; }
    [[nodiscard]] const LiveEstimate& estimate() const { return m_estimate; }

private:
    using Clock = std::chrono::steady_clock;
    /// On the axis of time: the device's own time, and on from there when one that came back counts anew.
    [[nodiscard]] std::vector<Sample> placed(std::vector<Sample> samples);
    /// In the unit of the force channel; none where that is no unit of force.
    [[nodiscard]] std::vector<std::optional<double>> commandedForces(const std::vector<Sample>& samples,
                                                                     ConnectSession& connection);

    LiveHistory m_history;
    LiveEstimate m_estimate;
    CommandedForce m_commanded;
    double m_shift_s = 0;
    bool m_returned = false; ///< and nothing came of it yet
    Clock::time_point m_newest;
};

} // namespace gripscope
