// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_port.h"

#include <optional>
#include <vector>

namespace gripscope {

/// Watches what a squeeze measures against its limits, beside the gripper's own watch: force, and travel from
/// where the movement began. Three samples in a row that are a twentieth above a limit: one may be noise, and
/// sensors err by a per cent or two, but no part that was given a limit is to be pressed further than that.
/// Channels whose units are not known cannot be watched.
class LimitWatch {
public:
    static constexpr double allowance = 0.05;
    static constexpr int samplesInRow = 3;

    LimitWatch() = default;
    LimitWatch(const JobLimits& limits, const GripperIdentity& identity);
    void take(const std::vector<Sample>& samples);
    /// DeviceRefused, with what was measured; from the moment on that it was.
    [[nodiscard]] const std::optional<Error>& exceeded() const { return m_exceeded; }

private:
    struct Channel {
        std::optional<double> perUnit; ///< SI in one unit of the channel
        double limit = 0;              ///< SI
        int above = 0;                 ///< so many in a row
        [[nodiscard]] bool exceededBy(double value);
    };
    void take(const Sample& sample);
    Channel m_force, m_travel;
    std::optional<double> m_start; ///< the position where the movement began
    std::optional<Error> m_exceeded;
};

} // namespace gripscope
