// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/field_problem.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace gripscope::protocol {

/// One HID report of the Gripscope protocol (devices/PROTOCOL.md): 64 bytes, the first of them the report ID,
/// the second the protocol version, the last two a CRC over all bytes before.
inline constexpr std::size_t reportSize = 64;
using Report = std::array<std::uint8_t, reportSize>;
using ReportView = std::span<const std::uint8_t>;

inline constexpr std::uint16_t vendorId = 0x1209;  ///< pid.codes, open source hardware
inline constexpr std::uint16_t productId = 0x0001; ///< its test identity; a product needs its own

inline constexpr std::uint8_t versionMajor = 1; ///< high half of the version byte: must match
inline constexpr std::uint8_t versionMinor = 1; ///< low half: newer ones only add

enum class ReportId : std::uint8_t {
    Stream = 0x01,
    Acknowledgement = 0x02,
    Identity = 0x10,
    Measurement = 0x11,
    Limits = 0x12,
    Arm = 0x20,
    Disarm = 0x21,
    Stop = 0x22,
    Heartbeat = 0x23,
    SetLimits = 0x24,
    Upload = 0x25,
    Start = 0x26,
    Finish = 0x27,
};

/// What a device answers to a command.
enum class CommandResult : std::uint8_t {
    Done = 0,
    Repeated = 1, ///< was done before; nothing more happened
    NotArmed = 2,
    Busy = 3, ///< an excitation is running
    LimitExceeded = 4,
    BadValue = 5,
    Incomplete = 6, ///< Start: samples are missing; detail is the first one
    ChecksumDiffers = 7,
    Spent = 8, ///< Upload, Start: the number is not ahead of the last start's, which is the detail
    UnknownCommand = 9,
    Fault = 10, ///< Arm: the device found something wrong with itself
};

enum class ExcitationState : std::uint8_t { None = 0, Loading = 1, Running = 2, Finished = 3, Stopped = 4 };

/// CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF, not reflected): "123456789" gives 0x29B1.
[[nodiscard]] std::uint16_t crc16(ReportView bytes);

/// Why a report was not understood.
struct DecodeError {
    enum Kind { Length, Crc, Version, UnknownReport, BadField };

    // Implicit, so that a decoder can say `DecodeError::Crc` where there is nothing to add.
    DecodeError(Kind what, std::size_t found = 0) : kind(what), came(found) {}
    [[nodiscard]] static DecodeError badField(const FieldProblem& problem)
    {
        DecodeError error(BadField);
        error.field = problem;
        return error;
    }
    [[nodiscard]] static DecodeError unknownReport(std::uint8_t id) { return {UnknownReport, id}; }

    Kind kind;
    std::size_t came;                  ///< Length: how many bytes; Version: that byte; UnknownReport: the ID
    std::optional<FieldProblem> field; ///< BadField: which one
    friend bool operator==(const DecodeError&, const DecodeError&) = default;
};

/// Checks length, version and CRC; the report ID as it stands (it may be one that is not known here).
[[nodiscard]] std::optional<DecodeError> checkReport(ReportView bytes);

/// Puts version and CRC in their places.
void seal(Report& report, std::uint8_t minor = versionMinor);

} // namespace gripscope::protocol
