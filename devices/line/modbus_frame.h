// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// Modbus over TCP as bytes: MODBUS Messaging on TCP/IP Implementation Guide V1.0b, MODBUS Application
// Protocol V1.1b3. Pure functions; whatever a client sends, they read nothing beyond it.

namespace gripscope {

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

} // namespace gripscope
