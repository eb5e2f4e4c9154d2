// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/recursive_estimator.h"
#include "core/session/gripper_port.h"

#include <optional>

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

} // namespace gripscope
