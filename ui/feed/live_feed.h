// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/connect_session.h"
#include "ui/feed/live_history.h"
#include "ui/feed/live_squeeze.h"

#include <chrono>
#include <optional>
#include <vector>

namespace gripscope {

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
