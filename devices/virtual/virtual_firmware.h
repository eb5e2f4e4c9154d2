// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random_stream.h"
#include "devices/protocol/codec.h"
#include "devices/virtual/virtual_part.h"

#include <deque>
#include <optional>
#include <vector>

namespace gripscope {

struct VirtualFirmwareOptions {
    VirtualObject object;
    QString objectName;
    VirtualTerms terms = {};
    std::uint64_t seed = 1;
    std::optional<std::uint64_t> noiseSeed = {}; ///< of its noise; `seed` where it is not given
    double sampleTime_s = 0.0005;                ///< 0.2 ms to 50 ms
    double jitter_s = 0; ///< standard deviation of when a position is taken; up to a quarter of a sample time
    /// 5 um beside steps of 20 um (5.8 um as a standard deviation) is what a mid-range encoder on a finger
    /// gives.
    double positionNoise_m = 5e-6;
    /// 0.2 % of the 10 N swing of the usual excitation. The force channel reports what is commanded plus
    /// this, so it is an error in the input; at 0.02 N it adds under 0.5 um to a position noise of 7.6 um,
    /// and its bias on m, b and k (noise to signal power, 4e-6) is far below their standard errors.
    double forceNoise_N = 0.02;
    bool millimetres = false; ///< states positions in mm instead of m
    bool hasWatchdog = true;  ///< off where time does not run by itself; what is stated stays
    std::uint16_t watchdog_ms = 100;
    std::uint32_t patience_ms = 0; ///< for tests: its watchdog waits so much longer once it has tripped
    std::uint8_t protocolMinor = protocol::versionMinor; ///< 0: it knows no token of an Arm
};

/// What can be wrong with the device itself, at any time.
struct FirmwareFaults {
    std::optional<double> saturateForce_N; ///< the force channel ends there
    bool sensorStuck = false;              ///< the position channel stays where it was
    bool broken = false;                   ///< it finds a fault in itself: stops, and does not arm
    double clock_s = 0;                    ///< its clock is ahead by so much
    double load_N = 0;                     ///< a weight hangs on the force sensor
    bool buttonDown = false;               ///< a person holds its button
    bool noWatchdog = false;               ///< nothing trips when it hears nothing
    double clockRate = 0; ///< its time is fast by this share: its samples come sooner than it says
};

/// A gripper without hardware: what its firmware would do, sample for sample, in the bytes of
/// devices/PROTOCOL.md.
///
/// The object (VirtualPart) moves from rest at the contact point, exactly for a force that is held between
/// samples. Each start takes up another object (VirtualObject::draw) and restarts the noise from
/// (seed, number of the squeeze), so the n-th squeeze does not depend on what was before it. The grip pushes
/// only: no force below zero is taken. No thread, no clock: who owns it says when a sample is due.
class VirtualFirmware {
public:
    static constexpr double forcePerCount_N = 0.001;
    static constexpr double positionPerCount_m = 20e-6; ///< the step of its encoder
    static constexpr double maxForce_N = 100;
    static constexpr double maxTravel_m = 0.025;
    static constexpr std::int32_t ownForce = 100'000; ///< counts of it
    static constexpr std::int32_t ownTravel = 1'250;
    static_assert(ownForce * forcePerCount_N == maxForce_N && ownTravel * positionPerCount_m == maxTravel_m);
    static constexpr std::uint32_t maxSamples = 32768;
    /// At rest before and after an excitation: enough to keep 20 ms of it though reports get lost.
    static constexpr double restBefore_s = 0.05, restAfter_s = 0.06;
    /// A fault is shown at least so long, and a measured force or travel stops it when that many samples in a
    /// row are beyond: 20 ms of reports are not all lost, and three samples are not one spark.
    static constexpr double faultShown_s = 0.02;
    static constexpr int samplesBeyond = 3;

    explicit VirtualFirmware(VirtualFirmwareOptions options);

    /// It made so many squeezes before it was switched on this time, and does not repeat them.
    void goOnAfter(std::uint64_t squeezes) { m_squeezes = squeezes; }
    [[nodiscard]] std::optional<protocol::Report> feature(std::uint8_t reportId) const;
    /// One output report; `now_us` is the time by which the watchdog counts. Damaged ones get no answer.
    void receive(protocol::ReportView bytes, std::uint64_t now_us);
    /// Takes one sample; `now_us` as above.
    void sample(std::uint64_t now_us);
    void setFaults(const FirmwareFaults& faults);
    /// Reports ready to be sent, oldest first; the caller takes them out.
    [[nodiscard]] std::deque<protocol::Report>& outbox() { return m_outbox; }

    /// An excitation is under way, the rest before and behind it included.
    [[nodiscard]] bool busy() const { return m_phase != Phase::Idle; }
    [[nodiscard]] bool settling() const { return m_phase == Phase::RestAfter; }
    [[nodiscard]] double sampleTime_s() const { return m_options.sampleTime_s; }
    /// At least one.
    [[nodiscard]] std::uint32_t samplesIn(double seconds) const;
    [[nodiscard]] std::uint64_t samplesTaken() const { return m_sampleCount; }
    [[nodiscard]] std::uint64_t squeezesStarted() const { return m_squeezes; }

private:
    enum class Phase { Idle, RestBefore, Moving, RestAfter };
    struct Reading {
        protocol::RawSample raw;
        std::uint16_t status = 0;
    };
    struct Answer {
        protocol::CommandResult result = protocol::CommandResult::Done;
        std::uint32_t detail = 0;
    };

    Answer execute(const protocol::CommandBody& body);
    Answer arm(const protocol::ArmCommand& command);
    Answer disarm();
    Answer setLimits(const protocol::SetLimitsCommand& limits);
    Answer upload(const protocol::UploadCommand& upload);
    Answer start(const protocol::StartCommand& start);
    Answer finish(const protocol::FinishCommand& finish);
    Answer refuseForces(const std::int32_t* forces, std::size_t count, std::uint32_t firstIndex) const;
    [[nodiscard]] static bool feedsWatchdog(const protocol::CommandBody& body,
                                            protocol::CommandResult result);
    void watch(std::uint64_t now_us); ///< the watchdog
    void acknowledge(std::uint16_t number, protocol::ReportId command, Answer answer);
    void halt(std::uint16_t cause); ///< force off, disarmed, cause shown until the next Arm
    void protect(const protocol::RawSample& measured); ///< stops it beyond the limits
    [[nodiscard]] bool faultShown() const { return m_faults.broken || m_sampleCount < m_faultShownUntil; }
    /// The force is still to come or on; while it settles behind that, the next excitation may be uploaded.
    [[nodiscard]] bool restsOrMoves() const
    {
        return m_phase == Phase::RestBefore || m_phase == Phase::Moving;
    }
    [[nodiscard]] bool running() const { return m_excitation == protocol::ExcitationState::Running; }
    void beginSqueeze();
    double nextForce(); ///< what is applied from this sample to the next, N
    void advancePhase();
    [[nodiscard]] std::uint16_t status() const;
    [[nodiscard]] Reading read(double force_N);
    [[nodiscard]] double positionTaken(double force_N);
    void put(const Reading& reading);
    void flush();
    [[nodiscard]] protocol::Report sealed(protocol::Report report) const; ///< with its own version
    [[nodiscard]] std::uint32_t timestamp_us(std::uint64_t sample) const;

    VirtualFirmwareOptions m_options;
    FirmwareFaults m_faults;
    std::deque<protocol::Report> m_outbox;
    protocol::StreamReport m_pending;
    std::uint32_t m_reportSequence = 0;
    std::uint64_t m_sampleCount = 0;

    bool m_armed = false;
    std::uint16_t m_latched = 0;               ///< status bits that stay until the next Arm
    std::uint32_t m_lastToken = 0;             ///< of the Arm that was taken last
    std::uint64_t m_fed_us = 0;                ///< when the watchdog's time began anew
    bool m_tripped = false;                    ///< the watchdog, once or more often
    std::uint64_t m_faultShownUntil = 0;       ///< sample
    std::int32_t m_maxForce, m_maxTravel;      ///< counts
    std::int32_t m_travelFrom = 0;             ///< counts: the position of the first moving sample
    int m_forceBeyond = 0, m_travelBeyond = 0; ///< samples in a row

    std::vector<std::int32_t> m_forces;
    std::vector<bool> m_uploaded;
    std::uint32_t m_uploadedEnd = 0; ///< one past the highest index uploaded
    protocol::ExcitationState m_excitation = protocol::ExcitationState::None;
    std::uint16_t m_excitationNumber = 0;
    std::uint16_t m_lastStarted = 0;
    bool m_anyStarted = false; ///< since it was switched on

    Phase m_phase = Phase::Idle;
    std::uint32_t m_phaseIndex = 0;
    std::uint32_t m_length = 0;
    std::uint64_t m_squeezes = 0;
    VirtualPart m_part;
    VirtualPart m_before; ///< a sample earlier, where positions are taken at irregular times
    double m_forceBefore_N = 0;
    RandomStream m_noise, m_jitter;
    std::optional<std::int32_t> m_stuckPosition;
};

} // namespace gripscope
