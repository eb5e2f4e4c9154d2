// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/messages.h"

#include <tl/expected.hpp>

#include <variant>
#include <vector>

namespace gripscope::protocol {

/// What a Measurement feature may state, both ends included. A count below a millionth of a millionth of its
/// unit or above a million of them is no sensor's; a microsecond is the resolution of the device's own clock;
/// a position that is taken 0.1 s beside its force does not belong to it any more.
inline constexpr double leastPerCount = 1e-12, mostPerCount = 1e6;
inline constexpr double shortestSampleTime_s = 1e-6, longestSampleTime_s = 1;
inline constexpr double longestLag_s = 0.1;

/// Which number of Set limits was refused, as the detail of its answer.
inline constexpr std::uint32_t limitsDetailForce = 1, limitsDetailTravel = 2;

/// Pure functions between messages and the 64 bytes of devices/PROTOCOL.md. decode(encode(x)) == x for every
/// x whose fields are within their stated ranges; unused bytes and unused samples are written as zero and
/// ignored when read.
[[nodiscard]] Report encode(const StreamReport& message);
[[nodiscard]] Report encode(const Acknowledgement& message);
[[nodiscard]] Report encode(const Command& message);
[[nodiscard]] Report encode(const IdentityFeature& message);
[[nodiscard]] Report encode(const MeasurementFeature& message);
[[nodiscard]] Report encode(const LimitsFeature& message);

template <typename T>
using Decoded = tl::expected<T, DecodeError>;

/// What a device sends by itself.
using InputMessage = std::variant<StreamReport, Acknowledgement>;
[[nodiscard]] Decoded<InputMessage> decodeInput(ReportView bytes);
[[nodiscard]] Decoded<Command> decodeCommand(ReportView bytes);
/// A feature that could be read may still be one of a gripper that must not be armed: armingObstacle().
[[nodiscard]] Decoded<IdentityFeature> decodeIdentity(ReportView bytes);
[[nodiscard]] Decoded<MeasurementFeature> decodeMeasurement(ReportView bytes);
[[nodiscard]] Decoded<LimitsFeature> decodeLimits(ReportView bytes);

/// The report ID a command travels under.
[[nodiscard]] ReportId reportId(const CommandBody& body);

/// CRC-16 over the forces as little-endian 32-bit integers, as Start carries it.
[[nodiscard]] std::uint16_t forcesCrc(const std::vector<std::int32_t>& forces);

/// Words for a result, to follow "the gripper refused to ...: ".
[[nodiscard]] const char* describe(CommandResult result);
/// The same with what its detail says: "force 24 of the signal is above the limit". Translated.
[[nodiscard]] QString describe(ReportId command, CommandResult result, std::uint32_t detail);
/// Why a report was not understood, with what came: "it speaks version 2.0 of the protocol, this
/// program 1.1".
[[nodiscard]] QString describe(const DecodeError& error);

} // namespace gripscope::protocol
