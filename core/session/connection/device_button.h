// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"

namespace gripscope {

/// Status bit of a sample, beside those of SampleStatus: the gripper's own button is down. It says nothing of
/// the measurement.
inline constexpr std::uint16_t statusButton = 1 << 8;

/// Sees when a person presses the button: it was up in one sample and is down in a later one. A button that
/// is down when the samples begin was pressed for something else, or sticks: that is no press.
class ButtonWatch {
public:
    /// Whether the button was pressed in these samples, which follow those taken before. Several presses in
    /// one batch (some 16 ms) are one.
    [[nodiscard]] bool pressedIn(const std::vector<Sample>& samples)
    {
        bool pressed = false;
        for (const Sample& sample : samples) {
            const bool isDown = (sample.status & statusButton) != 0;
            pressed = pressed || (m_up && isDown);
            m_up = !isDown;
        }
        return pressed;
    }
    /// Samples of another connection follow.
    void reset() { m_up = false; }

private:
    bool m_up = false; ///< and that is known
};

} // namespace gripscope
