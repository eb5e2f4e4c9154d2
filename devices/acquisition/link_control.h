// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/limit_watch.h"
#include "devices/acquisition/arming.h"
#include "devices/acquisition/command_queue.h"
#include "devices/acquisition/stop_sequence.h"
#include "devices/transport/device_description.h"
#include "devices/transport/report_decoder.h"

#include <span>

namespace gripscope {

/// Everything that a link decides: what is sent when, what is believed, and when the gripper is stopped. No
/// thread, no clock, no lock: its owner says what came and what time it is, so that a test can play any
/// gripper in no time.
///
/// What it sees to, with or without a screen:
/// - a gripper is armed only after its description was found fit, its reports come fast enough and its
///   watchdog was seen to work (Arming);
/// - while it is armed, or says that it is, or may be: force and travel of every sample are within the limits
///   of the squeeze (of the device, before the first), good samples are younger than 50 ms, it reports no
///   fault, and nobody else's commands are answered: else it is stopped and disarmReason() says why;
/// - heartbeats only while all that holds and the owner is alive;
/// - a stop is followed until it was obeyed; a gripper that did not is never armed again by this connection.
class LinkControl {
public:
    using Clock = std::chrono::steady_clock;
    using Time = Clock::time_point;

    struct Options {
        LinkLimits limits = {};
        bool realTime = true; ///< false: a virtual gripper whose time waits for its reader
        std::uint16_t lastNumber =
            0; ///< of commands; and the token of Arm: so that two programs hardly share them
        std::uint32_t lastToken = 0;
    };
    LinkControl() = default; ///< of a gripper that takes no commands: nothing is ever sent
    LinkControl(const DeviceDescription& device, const Options& options);

    // What the owner of the port wants.
    void arm(Time now);
    void disarm(Time now);
    void stop(Time now);
    void start(const AdmittedExcitation& excitation, Time now);
    void refuseSqueeze() { m_squeeze.state = SqueezeState::Refused; }
    void finish();
    /// The connection ends: a stop, where the gripper is or may be armed.
    void close(Time now);

    // What came.
    void takeSamples(std::span<const Sample> samples, std::uint64_t pushed, Time now);
    void takeState(const ReportDecoder::DeviceState& state, Time now);
    void takeAnswer(const protocol::Acknowledgement& answer, Time now);
    void takeBadReport(Time now);
    /// Everything that came before `time` was read.
    void heard(Time time, Time now);
    /// The device went away.
    void lose();

    // What is to be done.
    [[nodiscard]] std::optional<protocol::Report> next(Time now, Time aliveAt);
    [[nodiscard]] Time wakeAt(Time now) const;
    /// next() has something that did not wait before.
    [[nodiscard]] bool wantsToWrite(Time now) const;
    /// Nothing is left to send before a connection may be closed.
    [[nodiscard]] bool mayClose(Time now) const;

    // What is so.
    [[nodiscard]] bool armed() const { return m_arming.step() == Arming::Step::Armed; }
    [[nodiscard]] StopState stopState(Time now);
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }
    [[nodiscard]] const std::optional<Error>& disarmReason() const { return m_disarmReason; }
    struct Squeeze {
        SqueezeState state = SqueezeState::Idle;
        std::uint16_t number = 0;
        std::uint64_t samplesBefore = 0; ///< pushed up to its end: it shows as ended once they are drained
    };
    [[nodiscard]] const Squeeze& squeeze() const { return m_squeeze; }
    void fill(LinkCounters& counters) const { m_commands.fill(counters); }

private:
    void halt(protocol::CommandBody body, Time now, bool mayBeArmed = false);
    void stopBecause(Error reason, Time now);
    void refuseToArm(const QString& why);
    void followArming(Time now);
    void followSqueeze(protocol::ExcitationState excitation, std::uint16_t number);
    void settle(const CommandQueue::Outcome& outcome, const protocol::Acknowledgement& answer, Time now);
    void refuse(const CommandQueue::Outcome& outcome, Time now);
    void endSqueeze(SqueezeState state);
    void watchFrom(const JobLimits& limits); ///< from the position where it is
    void restHere(Time now);                 ///< the force that is there now is none of the gripper's
    [[nodiscard]] double harmless() const;   ///< a force that is no grip, in the channel's unit
    [[nodiscard]] bool squeezing() const;
    /// The gripper is armed, or may be: everything is watched.
    [[nodiscard]] bool guarded() const;
    [[nodiscard]] bool fresh(Time now) const;
    [[nodiscard]] bool heartbeatDue(Time now, Time aliveAt);
    [[nodiscard]] bool olderThanAnswer(std::uint32_t timestamp_us);
    [[nodiscard]] double distanceFromRest(double force) const { return force - m_restForce; }
    void rememberForce(double distance, Time now);
    [[nodiscard]] Error blindness(Time now) const;

    Options m_options;
    DeviceDescription m_device;
    bool m_commandable = false;
    CommandQueue m_commands;
    StreamPulse m_pulse;
    Arming m_arming;
    StopSequence m_stop;
    bool m_disobeyed = false;
    std::optional<Error> m_error, m_disarmReason;
    Squeeze m_squeeze;
    std::uint16_t m_nextExcitation = 1;
    std::uint32_t m_token = 0;

    JobLimits m_limits;
    LimitWatch m_watch;
    bool m_deviceArmed = false; ///< as its stream says
    double m_position = 0;      ///< newest
    double m_restForce = 0;     ///< as it was when it was armed, or a squeeze begun
    double m_newestForce = 0;
    struct {
        Time since{};
        double now = 0, before = 0;
    } m_force; ///< largest distance from rest in this spell of 50 ms and the one before
    std::uint64_t m_pushed = 0;
    Time m_lastSample{}, m_lastHeartbeat{};
    std::optional<Time> m_lastBad, m_foreign;     ///< when
    bool m_frozen = false;                        ///< heartbeats are withheld: the owner does nothing
    std::optional<std::uint32_t> m_lastAnswer_us; ///< device's clock; until a report is newer
};

} // namespace gripscope
