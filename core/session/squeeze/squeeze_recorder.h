// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"

#include <cstddef>
#include <vector>

namespace gripscope {

/// Keeps the samples of one squeeze out of an endless stream: from a little before the device reports that it
/// moves to a little after, or simply the next so many seconds. Lost samples stay lost; time is the device's.
class SqueezeRecorder {
public:
    enum class Mode { Movement, Everything };
    /// Kept before and after the movement; the position settles in less on any part a gripper can hold
    /// firmly.
    static constexpr double margin_s = 0.02;

    void begin(Mode mode, std::size_t samples, double sampleTime_s);
    void take(const std::vector<Sample>& batch);

    [[nodiscard]] bool complete() const { return m_phase == Phase::Complete; }
    [[nodiscard]] bool moved() const { return m_mode == Mode::Movement && m_phase != Phase::Before; }
    [[nodiscard]] std::size_t size() const { return m_samples.size(); }
    [[nodiscard]] double movingSeconds() const; ///< from the first moving sample to the last, both included
    [[nodiscard]] double progress() const;      ///< 0 to 1
    /// All bits since the device was armed, also where it ended the squeeze before anything moved: what it
    /// says of why. Those before it was armed may be old.
    [[nodiscard]] std::uint16_t statusSeen() const { return m_statusSeen; }
    /// Puts the samples into `recording` and forgets them, with what befell their stream and how its
    /// clocks ran (StreamAccount) unless the recording says so already.
    void moveTo(Recording& recording, const ClockAccount& clocks = {});

private:
    enum class Phase { Before, Moving, After, Complete };
    void take(const Sample& sample);
    void takeMovement(const Sample& sample);

    Mode m_mode = Mode::Movement;
    Phase m_phase = Phase::Before;
    std::vector<Sample> m_samples;
    std::size_t m_wanted = 0, m_margin = 0, m_after = 0;
    double m_sampleTime_s = 0;
    double m_firstMoving_s = 0, m_lastMoving_s = 0;
    bool m_armed = false;
    std::uint16_t m_statusSeen = 0;
};

} // namespace gripscope
