// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/address/device_address.h"
#include "devices/transport/transport.h"
#include "devices/virtual/virtual_faults.h"
#include "devices/virtual/virtual_firmware.h"

#include <condition_variable>
#include <mutex>

namespace gripscope {

/// The virtual gripper behind the wire: firmware, time and faults.
///
/// At a speed above 0 the device's time is the computer's times the speed, and samples come all the time; the
/// watchdog counts the computer's time. At speed 0 time passes only while a squeeze runs (with the rest
/// before and after it), and only as reports are asked for: nothing is ever too late, and the same seed gives
/// the same samples, numbers and times on every run. There is no watchdog at speed 0, since there is no time
/// for it.
///
/// Faults come by the device's time since open(). One that is unplugged stays gone for this transport; where
/// its faults plug it in again, the next transport with the same address opens from then on, and its faults
/// go on (virtual_plug.h). A feature request or a write that hangs blocks its caller as a system call does:
/// nothing ends it early, while reports are read as before.
class VirtualTransport : public Transport {
public:
    /// `patience`: see LinkLimits::virtualPatience.
    [[nodiscard]] static Expected<std::shared_ptr<VirtualTransport>>
    make(const VirtualAddress& address, std::chrono::milliseconds patience = {});
    VirtualTransport(const VirtualAddress& address, VirtualFirmwareOptions options);

    /// DeviceNotFound while it is unplugged; or what is wrong with the script of its faults.
    Expected<void> open() override;
    Expected<protocol::Report> feature(protocol::ReportId id) override;
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override;
    bool write(const protocol::Report& report) override;
    void close() noexcept override;
    [[nodiscard]] bool streamsAlways() const override { return m_address.speed > 0; }
    [[nodiscard]] bool keepsComputerTime() const override { return m_address.speed == 1; }

    /// What the faults did so far.
    [[nodiscard]] FaultCounts faultCounts();

private:
    using Clock = std::chrono::steady_clock;
    using Lock = std::unique_lock<std::mutex>;
    [[nodiscard]] bool realTime() const { return m_address.speed > 0; }
    [[nodiscard]] std::uint64_t hostTime_us() const;
    /// When samples are taken, in the computer's time: from one of them on at one rate.
    struct Pace {
        double from_us = 0;
        std::uint64_t sample = 0;
        double rate = 0; ///< samples in a microsecond
        [[nodiscard]] double at_us(std::uint64_t n) const
        {
            return rate > 0 ? from_us + static_cast<double>(n - sample) / rate : from_us;
        }
    };
    void advance(); ///< to now, or at speed 0 until a report is there or the squeeze is over
    void takeSample(std::uint64_t now_us);
    void deliver();      ///< from the firmware onto the wire, through the faults
    void followFaults(); ///< to the device's time
    void rememberUnplug() const;
    [[nodiscard]] double faults_s() const;
    [[nodiscard]] bool usable() const { return m_open && !m_closed && !m_unplugged; }
    [[nodiscard]] static bool hang(Lock& lock, double seconds);

    const VirtualAddress m_address;
    std::mutex m_mutex; ///< guards all below
    std::condition_variable m_wake;
    VirtualFirmware m_firmware;
    FaultTimeline m_timeline;
    double m_faultsBefore_s = 0; ///< what of the timeline passed before open()
    FaultInjector m_injector;
    std::uint64_t m_squeezesSeen = 0;
    std::deque<protocol::Report> m_wire;
    Clock::time_point m_start;
    Pace m_pace;
    bool m_open = false;
    bool m_closed = false;
    bool m_unplugged = false;
};

} // namespace gripscope
