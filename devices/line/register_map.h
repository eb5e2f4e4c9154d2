// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/job_desk.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

// The registers by which a PLC speaks to a station, version 1. A register has 16 bits; of two that are one
// value the high word comes first; float32 is IEEE 754. The manual's page "From one station to a plant" has
// the table, which a test holds to registerFields().

namespace line_register {
inline constexpr int mapVersion = 1;
inline constexpr int commandFirst = 0, commandCount = 10;
inline constexpr int statusFirst = 100, statusCount = 20;
inline constexpr int resultFirst = 120, resultCount = 28;
inline constexpr int heartbeat = 0, acknowledge = 1, trigger = 4, type = 5, partToken = 6,
                     wanted = 8;        // written by the PLC
inline constexpr int wantedFirst = 200; ///< the result that it wants, laid out as from resultFirst on
inline constexpr int checksum = resultFirst + resultCount - 1;
} // namespace line_register

enum class RegisterType { UInt16, UInt32, Bits, Float32 };
struct RegisterField {
    int address = 0;
    RegisterType type = RegisterType::UInt16;
    const char* name = ""; ///< as the manual has it
    bool written = false;  ///< by the PLC
};
/// In the order of their addresses.
[[nodiscard]] const std::vector<RegisterField>& registerFields();
[[nodiscard]] const char* toString(RegisterType type); ///< "uint16", "uint32", "bits", "float32"

namespace line_status_bit {
inline constexpr std::uint16_t ready = 1, busy = 2, resultValid = 4, armed = 8, simulated = 16, plcAlive = 32;
}
namespace line_result_bit {
inline constexpr std::uint16_t partial = 1, simulated = 2;
inline constexpr std::uint16_t quantityKnown = 4;     ///< m; shifted by 1 for b and by 2 for k
inline constexpr std::uint16_t uncertaintyKnown = 32; ///< of m; the same
} // namespace line_result_bit

/// CRC-16/MODBUS (polynomial 0xA001 reflected, start 0xFFFF) over the registers' bytes, the high byte first.
[[nodiscard]] std::uint16_t registerChecksum(std::span<const std::uint16_t> registers);

/// Status and result block: registers statusFirst to checksum, of one moment. Values that are not known are
/// 0, and their bit says so; nothing is NaN.
[[nodiscard]] std::vector<std::uint16_t> encodeView(const JobDesk::View& view);

/// The registers from resultFirst to checksum. Nothing: zeros with their checksum.
[[nodiscard]] std::vector<std::uint16_t> encodeResult(const std::optional<LineResult>& result);

/// What a write asks for. Nothing where it leaves a pair or a job in pieces: the job's four registers and the
/// two of an acknowledge or of a result that is wanted are only taken whole, so that no two writes mix.
struct LineCommands {
    std::optional<std::uint16_t> beat;
    std::optional<std::uint32_t> release;
    std::optional<LineJob> job;
};
[[nodiscard]] std::optional<LineCommands> decodeWrite(int first, std::span<const std::uint16_t> values);

} // namespace gripscope
