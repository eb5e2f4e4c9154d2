// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/modbus_registers.h"

#include <array>

namespace gripscope {

namespace {

using ModbusBytes = std::span<const std::uint8_t>;

constexpr std::size_t headerBytes = 7, longestPdu = 253; // of the guide
constexpr unsigned mostRead = 125, mostWritten = 123, mostWrittenAndRead = 121;

unsigned wordAt(ModbusBytes bytes, std::size_t index)
{
    return (unsigned(bytes[index]) << 8U) | bytes[index + 1];
}

void appendWord(std::vector<std::uint8_t>& bytes, unsigned word)
{
    bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
    bytes.push_back(static_cast<std::uint8_t>(word & 0xFFU));
}

std::vector<std::uint8_t> exceptionPdu(std::uint8_t function, ModbusException problem)
{
    return {static_cast<std::uint8_t>(function | 0x80U), static_cast<std::uint8_t>(problem)};
}

std::vector<std::uint8_t> readAnswer(std::uint8_t function, unsigned first, unsigned count,
                                     RegisterAccess& registers)
{
    std::array<std::uint16_t, mostRead> values{};
    if (count < 1 || count > mostRead)
        return exceptionPdu(function, ModbusException::IllegalValue);
    if (const auto problem = registers.read(static_cast<int>(first), std::span(values).first(count)))
        return exceptionPdu(function, *problem);
    std::vector<std::uint8_t> answer{function, static_cast<std::uint8_t>(2 * count)};
    for (unsigned i = 0; i < count; ++i)
        appendWord(answer, values[i]);
    return answer;
}

/// The registers from byte `at` on, behind their number of bytes.
std::optional<ModbusException> writeFrom(ModbusBytes request, std::size_t at, unsigned first, unsigned count,
                                         unsigned most, RegisterAccess& registers)
{
    std::array<std::uint16_t, mostWritten> values{};
    const std::size_t bytes = std::size_t{2} * count;
    if (count < 1 || count > most || request[at] != bytes || request.size() != at + 1 + bytes)
        return ModbusException::IllegalValue;
    for (std::size_t i = 0; i < count; ++i)
        values[i] = static_cast<std::uint16_t>(wordAt(request, at + 1 + 2 * i));
    return registers.write(static_cast<int>(first), std::span<const std::uint16_t>(values).first(count));
}

std::vector<std::uint8_t> writeOne(ModbusBytes request, RegisterAccess& registers)
{
    if (request.size() != 5)
        return exceptionPdu(request[0], ModbusException::IllegalValue);
    const std::array value{static_cast<std::uint16_t>(wordAt(request, 3))};
    if (const auto problem = registers.write(static_cast<int>(wordAt(request, 1)), value))
        return exceptionPdu(request[0], *problem);
    return {request.begin(), request.end()};
}

std::vector<std::uint8_t> writeSeveral(ModbusBytes request, RegisterAccess& registers)
{
    if (request.size() < 6)
        return exceptionPdu(request[0], ModbusException::IllegalValue);
    if (const auto problem =
            writeFrom(request, 5, wordAt(request, 1), wordAt(request, 3), mostWritten, registers))
        return exceptionPdu(request[0], *problem);
    return {request.begin(), request.begin() + 5};
}

std::vector<std::uint8_t> writeAndRead(ModbusBytes request, RegisterAccess& registers)
{
    if (request.size() < 10 || wordAt(request, 3) < 1 || wordAt(request, 3) > mostRead)
        return exceptionPdu(request[0], ModbusException::IllegalValue);
    // A range that cannot be read is found before anything is written.
    std::array<std::uint16_t, mostRead> ignored{};
    const unsigned first = wordAt(request, 1), count = wordAt(request, 3);
    if (const auto problem = registers.read(static_cast<int>(first), std::span(ignored).first(count)))
        return exceptionPdu(request[0], *problem);
    if (const auto problem =
            writeFrom(request, 9, wordAt(request, 5), wordAt(request, 7), mostWrittenAndRead, registers))
        return exceptionPdu(request[0], *problem);
    return readAnswer(request[0], first, count, registers);
}

} // namespace

std::vector<std::uint8_t> answerPdu(std::span<const std::uint8_t> request, RegisterAccess& registers)
{
    switch (request[0]) {
    case 3:
    case 4:
        return request.size() == 5 ? readAnswer(request[0], wordAt(request, 1), wordAt(request, 3), registers)
                                   : exceptionPdu(request[0], ModbusException::IllegalValue);
    case 6:
        return writeOne(request, registers);
    case 16:
        return writeSeveral(request, registers);
    case 23:
        return writeAndRead(request, registers);
    default:
        return exceptionPdu(request[0], ModbusException::IllegalFunction);
    }
}

FrameState nextFrame(std::span<const std::uint8_t> stream, ModbusFrame& frame)
{
    if (stream.size() < headerBytes)
        return FrameState::Incomplete;
    const unsigned length = wordAt(stream, 4); // of what follows it: the unit and the request
    if (wordAt(stream, 2) != 0 || length < 2 || length > longestPdu + 1)
        return FrameState::Broken;
    if (stream.size() < headerBytes - 1 + length)
        return FrameState::Incomplete;
    frame.transaction = static_cast<std::uint16_t>(wordAt(stream, 0));
    frame.unit = stream[6];
    frame.bytes = headerBytes - 1 + length;
    frame.pdu = stream.subspan(headerBytes, length - 1);
    return FrameState::Whole;
}

std::vector<std::uint8_t> framed(const ModbusFrame& request, std::span<const std::uint8_t> pdu)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(headerBytes + pdu.size());
    appendWord(bytes, request.transaction);
    appendWord(bytes, 0);
    appendWord(bytes, static_cast<unsigned>(pdu.size() + 1));
    bytes.push_back(request.unit);
    bytes.insert(bytes.end(), pdu.begin(), pdu.end());
    return bytes;
}

} // namespace gripscope
