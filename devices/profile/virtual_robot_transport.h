// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/device_address.h"
#include "devices/profile/profile_encoder.h"
#include "devices/profile/virtual_robot.h"
#include "devices/transport.h"
#include "devices/virtual/fault_timeline.h"

#include <condition_variable>
#include <deque>
#include <mutex>

namespace gripscope {

/// A virtual gripper of another maker: a robot that squeezes by itself, in the bytes of a profile.
///
/// At a speed above 0 the device's time is the computer's times the speed. At speed 0 reports come as fast as
/// they are asked for, and after `samplesAtSpeedZero` the stream is through, so that a program that takes
/// nothing out is not flooded. Faults as the virtual gripper's, where they mean anything: what is written is
/// not taken at all, and there is no CRC that would show a flipped bit.
class VirtualRobotTransport : public Transport {
public:
    static constexpr std::uint64_t samplesAtSpeedZero = 60000;

    /// `profile`: how it sends; called by open(), so that it may read a file.
    VirtualRobotTransport(VirtualAddress address, std::function<Expected<GripperProfile>()> profile);

    Expected<void> open() override;
    Expected<protocol::Report> feature(protocol::ReportId id) override;
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override;
    bool write(const protocol::Report&) override { return false; }
    void close() noexcept override;
    [[nodiscard]] bool streamsAlways() const override { return realTime(); }
    [[nodiscard]] bool takesCommands() const override { return false; }

    /// From open() on.
    [[nodiscard]] const GripperProfile& profile() const { return m_device->profile; }
    [[nodiscard]] std::uint64_t lostReports(); ///< what the faults took away so far

private:
    using Clock = std::chrono::steady_clock;
    struct Device {
        Device(const GripperProfile& sent, const VirtualRobotOptions& options)
            : profile(sent), encoder(sent), robot(options)
        {
        }
        GripperProfile profile;
        ProfileEncoder encoder;
        VirtualRobot robot;
    };
    [[nodiscard]] bool realTime() const { return m_address.speed > 0; }
    void advance();
    void sendReport();
    void unplug();
    void pass(std::vector<std::uint8_t> report);
    [[nodiscard]] ProfileEncoder::Reading takeSample();
    [[nodiscard]] double deviceTime_s() const;

    const VirtualAddress m_address;
    const std::function<Expected<GripperProfile>()> m_findProfile;
    std::mutex m_mutex; ///< guards all below
    std::condition_variable m_wake;
    std::unique_ptr<Device> m_device; ///< from open() on
    FaultTimeline m_faults;
    double m_faultsBefore_s = 0; ///< what of them passed before open()
    RandomStream m_faultDice;
    std::optional<double> m_stuckAt_m;
    std::deque<std::vector<std::uint8_t>> m_wire;
    std::uint64_t m_samples = 0, m_lostReports = 0;
    Clock::time_point m_start;
    bool m_unplugged = false, m_closed = false;
};

} // namespace gripscope
