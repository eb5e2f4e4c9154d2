// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/job_desk.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

// Modbus over TCP as bytes: MODBUS Messaging on TCP/IP Implementation Guide V1.0b, MODBUS Application
// Protocol V1.1b3. Pure functions; whatever a client sends, they read nothing beyond it.

enum class ModbusException : std::uint8_t { IllegalFunction = 1, IllegalAddress = 2, IllegalValue = 3 };

/// Registers as a client reads and writes them: each call is of one moment.
class RegisterAccess {
public:
    virtual ~RegisterAccess() = default;
    /// Fills `values`; the problem where the range is not there.
    [[nodiscard]] virtual std::optional<ModbusException> read(int first, std::span<std::uint16_t> values) = 0;
    [[nodiscard]] virtual std::optional<ModbusException> write(int first,
                                                               std::span<const std::uint16_t> values) = 0;
};

/// The answer to a request without its header: functions 3 and 4 (read, the same registers), 6 and 16 (write)
/// and 23 (write, then read); others are IllegalFunction. `request` has at least its function code.
[[nodiscard]] std::vector<std::uint8_t> answerPdu(std::span<const std::uint8_t> request,
                                                  RegisterAccess& registers);

struct ModbusFrame {
    std::size_t bytes = 0; ///< of the whole frame
    std::uint16_t transaction = 0;
    std::uint8_t unit = 0; ///< answered whatever it is: there is one station behind an address
    std::span<const std::uint8_t> pdu;
};
enum class FrameState { Whole, Incomplete, Broken };
/// The frame at the beginning of `stream`. Broken: no Modbus (another protocol number, an impossible length);
/// nothing behind it can be trusted.
[[nodiscard]] FrameState nextFrame(std::span<const std::uint8_t> stream, ModbusFrame& frame);
[[nodiscard]] std::vector<std::uint8_t> framed(const ModbusFrame& request, std::span<const std::uint8_t> pdu);

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

/// The registers over a desk: a read of status and result is one look at it, a write is heartbeat,
/// acknowledge and job in this order. What was written reads back. The result that is wanted (GetResultById)
/// is looked up when it is read: of the newest JobDesk::mostKept, released or not.
class LineRegisters : public RegisterAccess {
public:
    explicit LineRegisters(std::shared_ptr<SharedJobDesk> desk) : m_desk(std::move(desk)) {}
    [[nodiscard]] std::optional<ModbusException> read(int first, std::span<std::uint16_t> values) override;
    [[nodiscard]] std::optional<ModbusException> write(int first,
                                                       std::span<const std::uint16_t> values) override;

private:
    std::shared_ptr<SharedJobDesk> m_desk;
    std::array<std::uint16_t, line_register::commandCount> m_written{};
};

} // namespace gripscope
