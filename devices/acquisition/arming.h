// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/acquisition/link_limits.h"

#include <array>

namespace gripscope {

/// How fast the reports of a stream follow each other, by their arrival. What arrives together is one pulse:
/// ten reports at once, then nothing for a while, are not ten times as good as one.
class StreamPulse {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::size_t needed = 10; ///< pulses; fewer say nothing
    void take(Time now)
    {
        constexpr std::chrono::milliseconds together{2};
        if (m_count == 0 || now > m_times[(m_count - 1) % m_times.size()] + together)
            m_times[m_count++ % m_times.size()] = now;
    }
    [[nodiscard]] bool known() const { return m_count >= m_times.size(); }
    /// From one report to the next, over the last ten pulses; once known().
    [[nodiscard]] std::chrono::duration<double, std::milli> period() const
    {
        const Time newest = m_times[(m_count - 1) % m_times.size()];
        return std::chrono::duration<double, std::milli>(newest - m_times[m_count % m_times.size()]) /
               double(m_times.size() - 1);
    }

private:
    std::array<Time, needed> m_times{};
    std::size_t m_count = 0;
};

/// From a person's wish to an armed gripper. No thread, no clock.
///
///     Off -> Listening -> (ProofAsked -> ProofWaits ->) Asked -> Armed
///
/// Listening: until the reports are known to come fast enough. The proof, once a connection: it is armed and
/// then left alone, and must disarm itself with its watchdog bit no later than its watchdog's time and a
/// margin, and no sooner than half of it (a heartbeat may be late). Where something fails the gripper is not
/// armed, and refused() says why, in words that end "The gripper was not armed: ...".
class Arming {
public:
    using Time = std::chrono::steady_clock::time_point;
    enum class Step { Off, Listening, ProofAsked, ProofWaits, Asked, Armed };

    struct Device {
        std::chrono::milliseconds watchdog{0};
        bool realTime = true; ///< false: a virtual gripper whose time waits for its reader; nothing to prove
    };
    Arming() = default;
    Arming(const LinkLimits& limits, const Device& device)
        : m_limits(limits), m_device(device), m_proved(!device.realTime)
    {
    }

    void ask(Time now);
    void drop() { m_step = Step::Off; } ///< a stop
    /// Whether Arm is to be sent now; then it counts as sent.
    [[nodiscard]] bool sendArm(const StreamPulse& pulse, Time now);
    /// The device's answer, with the armed bit and the device's clock in it.
    void answered(bool armed, std::uint32_t device_us, Time now);
    /// A stream report: the device's armed and watchdog bits.
    void takeStatus(bool armed, bool watchdog, std::uint32_t device_us, Time now);
    /// Everything that came before `time` was read.
    void heard(Time time);
    struct Refusal {
        QString why;
        bool mayBeArmed = false; ///< all the same: it is to be stopped
    };
    [[nodiscard]] std::optional<Refusal> takeRefusal();

    [[nodiscard]] Step step() const { return m_step; }
    /// An Arm was sent, and what it brings about is on its way or there.
    [[nodiscard]] bool underWay() const { return m_step > Step::Listening; }

private:
    void refuse(const QString& why);
    void judgeTrip(bool watchdog, std::uint32_t device_us);

    LinkLimits m_limits;
    Device m_device;
    Step m_step = Step::Off;
    bool m_proved = false;
    Time m_since{};                  ///< of the step
    std::uint32_t m_answered_us = 0; ///< device's clock
    std::optional<Refusal> m_refusal;
};

} // namespace gripscope
