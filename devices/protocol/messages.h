// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"
#include "devices/protocol/report.h"

#include <string>
#include <variant>

namespace gripscope::protocol {

/// Force and position as the device counts them; the Measurement feature says what one count is.
struct RawSample {
    std::int32_t force = 0;
    std::int32_t position = 0;
    friend bool operator==(const RawSample&, const RawSample&) = default;
};

inline constexpr std::size_t maxSamplesPerReport = 5;
inline constexpr std::size_t maxForcesPerUpload = 12;

/// Input 0x01. All samples of a report share its status; `timestamp_us` and `firstSample` belong to the
/// first.
struct StreamReport {
    std::uint16_t status = 0; ///< SampleStatus bits
    std::uint32_t reportSequence = 0;
    std::uint32_t firstSample = 0;
    std::uint32_t timestamp_us = 0;
    ExcitationState excitation = ExcitationState::None;
    std::uint16_t excitationNumber = 0;
    std::uint8_t count = 0; ///< samples in use, 0 to 5
    std::array<RawSample, maxSamplesPerReport> samples{};
    friend bool operator==(const StreamReport&, const StreamReport&) = default;
};

/// Input 0x02.
struct Acknowledgement {
    std::uint16_t status = 0;
    std::uint16_t commandNumber = 0;
    ReportId command = ReportId::Heartbeat;
    CommandResult result = CommandResult::Done;
    std::uint32_t detail = 0; ///< see CommandResult and Arm
    std::uint32_t timestamp_us = 0;
    ExcitationState excitation = ExcitationState::None;
    std::uint16_t excitationNumber = 0;
    friend bool operator==(const Acknowledgement&, const Acknowledgement&) = default;
};

/// A program of version 1.1 gives each wish to arm a token of its own and repeats it with the same: a device
/// that took that token answers Repeated and arms no more. 0: a program of version 1.0, which has none.
struct ArmCommand {
    std::uint32_t token = 0;
    friend bool operator==(const ArmCommand&, const ArmCommand&) = default;
};
struct DisarmCommand {
    friend bool operator==(const DisarmCommand&, const DisarmCommand&) = default;
};
struct StopCommand {
    friend bool operator==(const StopCommand&, const StopCommand&) = default;
};
struct HeartbeatCommand {
    friend bool operator==(const HeartbeatCommand&, const HeartbeatCommand&) = default;
};
/// Both greater than 0 and at most the device's own.
struct SetLimitsCommand {
    std::int32_t maxForce = 0;
    std::int32_t maxTravel = 0;
    friend bool operator==(const SetLimitsCommand&, const SetLimitsCommand&) = default;
};
/// `count` forces of excitation `excitationNumber` from index `offset` on.
struct UploadCommand {
    std::uint16_t excitationNumber = 0;
    std::uint32_t offset = 0;
    std::uint8_t count = 0; ///< 1 to 12
    std::array<std::int32_t, maxForcesPerUpload> forces{};
    friend bool operator==(const UploadCommand&, const UploadCommand&) = default;
};
/// Starts an excitation of `samples` forces whose little-endian bytes have the given CRC-16.
struct StartCommand {
    std::uint16_t excitationNumber = 0;
    std::uint32_t samples = 0;
    std::uint16_t forcesCrc = 0;
    friend bool operator==(const StartCommand&, const StartCommand&) = default;
};
/// Ends that excitation as if its last force were reached: enough is known. The device stays armed.
struct FinishCommand {
    std::uint16_t excitationNumber = 0;
    friend bool operator==(const FinishCommand&, const FinishCommand&) = default;
};
/// From this minor version on a device remembers the token of an Arm, so that an Arm may be repeated.
inline constexpr std::uint8_t minorWithArmToken = 1;
using CommandBody = std::variant<ArmCommand, DisarmCommand, StopCommand, HeartbeatCommand, SetLimitsCommand,
                                 UploadCommand, StartCommand, FinishCommand>;
struct Command {
    std::uint16_t number = 0;
    CommandBody body;
    friend bool operator==(const Command&, const Command&) = default;
};

/// Feature 0x10. UTF-8; at most 24, 10 and 24 bytes. The minor version, 0 to 15, is that of the report's
/// version byte: what the device knows.
struct IdentityFeature {
    std::string serial, firmware, name;
    std::uint8_t protocolMinor = versionMinor;
    friend bool operator==(const IdentityFeature&, const IdentityFeature&) = default;
};

enum class ForceUnit : std::uint8_t { None = 0, Newton = 1, Millinewton = 2, Kilonewton = 3 };
enum class PositionUnit : std::uint8_t { None = 0, Metre = 1, Millimetre = 2, Micrometre = 3 };

/// Feature 0x11. Channel value = count * perCount, in the unit named.
struct MeasurementFeature {
    ForceUnit forceUnit = ForceUnit::Newton;
    PositionUnit positionUnit = PositionUnit::Metre;
    double forcePerCount = 1;
    double positionPerCount = 1;
    double sampleTime_s = 0;
    double forceLag_s = 0; ///< how much later the position channel samples than the force channel
    ForceHold hold = ForceHold::Zero;
    bool commandable = false;
    std::uint16_t watchdog_ms = 0;
    friend bool operator==(const MeasurementFeature&, const MeasurementFeature&) = default;
};

/// Feature 0x12, in counts; 0: none is stated, and the device cannot be armed.
struct LimitsFeature {
    std::int32_t maxForce = 0;
    std::int32_t maxTravel = 0;
    std::uint32_t maxSamples = 0;
    friend bool operator==(const LimitsFeature&, const LimitsFeature&) = default;
};

} // namespace gripscope::protocol
