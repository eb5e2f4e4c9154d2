// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random_stream.h"
#include "core/identification/model/discretization.h"
#include "devices/address/device_address.h"
#include "devices/address/virtual_object.h"
#include "devices/profile/profile_codec.h"
#include "devices/transport/transport.h"
#include "devices/virtual/virtual_faults.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <vector>

namespace gripscope {

struct VirtualRobotOptions {
    VirtualObject object;
    std::uint64_t seed = 1;
    double sampleTime_s = 0.001;
    ForceHold hold = ForceHold::Zero;
    double positionNoise_m = 5e-6; ///< both noises as the virtual gripper's
    double forceNoise_N = 0.02;
};

/// A robot that squeezes the same object again and again by a program of its own, sample for sample: a
/// second at rest, two seconds of pseudo-random force between 10 and 30 N, and so on.
///
/// The object is m x'' + b x' + k x = F, stepped exactly for the force's hold; it is
/// `object.draw(seed, 0)`, the same one every time, since nobody puts another into the fingers.
class VirtualRobot {
public:
    static constexpr double rest_s = 1;
    static constexpr double squeeze_s = 2;
    static constexpr double bias_N = 20;
    static constexpr double peak_N = 10;
    static constexpr double contact_m = 0.012347; ///< where the fingers touch the object
    static constexpr double range_m = 0.05;

    struct Reading {
        double force_N = 0, position_m = 0;
        bool moving = false;
    };

    explicit VirtualRobot(const VirtualRobotOptions& options);
    /// The next sample. One that starts a squeeze works out its force first.
    [[nodiscard]] Reading next();

private:
    [[nodiscard]] double plannedForce(std::uint64_t sample) const;
    void planSqueeze(std::uint64_t number);

    VirtualRobotOptions m_options;
    ExactStep<2> m_step;
    Eigen::Vector2d m_state = Eigen::Vector2d::Zero(); ///< position from the contact point and speed, SI
    RandomStream m_noise;
    std::uint64_t m_sample = 0;
    std::uint64_t m_restSamples, m_squeezeSamples;
    std::vector<double> m_squeeze_N; ///< that of the cycle under way
};

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
    [[nodiscard]] bool keepsComputerTime() const override { return m_address.speed == 1; }
    [[nodiscard]] bool takesCommands() const override { return false; }

    /// From open() on.
    [[nodiscard]] const GripperProfile& profile() const { return m_device->profile; }

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
    std::uint64_t m_samples = 0;
    Clock::time_point m_start;
    bool m_unplugged = false, m_closed = false;
};

} // namespace gripscope
