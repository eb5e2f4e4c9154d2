// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/messages.h"

#include <tl/expected.hpp>

#include <variant>
#include <vector>

namespace gripscope::protocol {

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
[[nodiscard]] Decoded<IdentityFeature> decodeIdentity(ReportView bytes);
[[nodiscard]] Decoded<MeasurementFeature> decodeMeasurement(ReportView bytes);
[[nodiscard]] Decoded<LimitsFeature> decodeLimits(ReportView bytes);

/// The report ID a command travels under.
[[nodiscard]] ReportId reportId(const CommandBody& body);

/// CRC-16 over the forces as little-endian 32-bit integers, as Start carries it.
[[nodiscard]] std::uint16_t forcesCrc(const std::vector<std::int32_t>& forces);

/// Words for a result, to follow "the gripper refused to ...: ".
[[nodiscard]] const char* describe(CommandResult result);
[[nodiscard]] const char* describe(DecodeError error);

} // namespace gripscope::protocol
