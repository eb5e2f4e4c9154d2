// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"

#include <optional>
#include <vector>

namespace gripscope {

/// The force limit of a squeeze that nobody gave one, in newtons: above the largest commanded force by a
/// tenth, or by five standard deviations of the force channel's noise where that is more. A limit at the
/// largest force itself would stop a device that compares what it measures: noise and the sensor's own error
/// are no excess.
[[nodiscard]] double limitAbove(double largest_N, double noiseDeviation_N);

/// Watches what is measured against limits, beside the gripper's own watch: force, and travel from a
/// position. Whether the gripper says that it moves does not matter. Three samples in a row that are a
/// twentieth above a limit: one may be noise, and sensors err by a per cent or two, but no part that was
/// given a limit is to be pressed further than that. Channels whose units are not known cannot be watched.
class LimitWatch {
public:
    static constexpr double allowance = 0.05;
    static constexpr int samplesInRow = 3;

    LimitWatch() = default;
    /// `start`: where travel is counted from, in the channel's unit; nothing: the first sample's position.
    LimitWatch(const JobLimits& limits, const GripperIdentity& identity, std::optional<double> start = {});
    void take(const Sample& sample);
    void take(const std::vector<Sample>& samples)
    {
        for (const Sample& sample : samples)
            take(sample);
    }
    /// Stopped, with what was measured; from the moment on that it was.
    [[nodiscard]] const std::optional<Error>& exceeded() const { return m_exceeded; }

private:
    struct Channel {
        std::optional<double> perUnit; ///< SI in one unit of the channel
        double limit = 0;              ///< SI
        int above = 0;                 ///< so many in a row
        [[nodiscard]] bool exceededBy(double value);
    };
    Channel m_force, m_travel;
    std::optional<double> m_start;
    std::optional<Error> m_exceeded;
};

} // namespace gripscope
