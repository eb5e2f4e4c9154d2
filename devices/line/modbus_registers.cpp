// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/modbus_registers.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gripscope {

const std::vector<RegisterField>& registerFields()
{
    using Type = RegisterType;
    static const std::vector<RegisterField> fields{
        {0, Type::UInt16, "PLC heartbeat", true},
        {1, Type::UInt32, "acknowledge", true},
        {3, Type::UInt16, "reserved", true},
        {4, Type::UInt16, "trigger", true},
        {5, Type::UInt16, "type", true},
        {6, Type::UInt32, "part token", true},
        {8, Type::UInt32, "result wanted", true},
        {100, Type::UInt16, "map version"},
        {101, Type::UInt16, "state"},
        {102, Type::Bits, "status bits"},
        {103, Type::UInt16, "station heartbeat"},
        {104, Type::UInt16, "last trigger"},
        {105, Type::UInt16, "answer"},
        {106, Type::UInt32, "overruns"},
        {108, Type::UInt32, "refused"},
        {110, Type::UInt32, "out of step"},
        {112, Type::UInt32, "run"},
        {120, Type::UInt32, "sequence"},
        {122, Type::UInt32, "part token"},
        {124, Type::UInt16, "trigger"},
        {125, Type::UInt16, "result state"},
        {126, Type::UInt16, "evaluation"},
        {127, Type::Bits, "result bits"},
        {128, Type::UInt16, "type asked for"},
        {129, Type::UInt16, "type found"},
        {130, Type::Float32, "m"},
        {132, Type::Float32, "standard uncertainty of m"},
        {134, Type::Float32, "b"},
        {136, Type::Float32, "standard uncertainty of b"},
        {138, Type::Float32, "k"},
        {140, Type::Float32, "standard uncertainty of k"},
        {142, Type::UInt32, "time"},
        {144, Type::UInt16, "milliseconds"},
        {145, Type::UInt16, "reason"},
        {146, Type::UInt16, "reserved"},
        {147, Type::UInt16, "checksum"},
    };
    return fields;
}

const char* toString(RegisterType type)
{
    switch (type) {
    case RegisterType::UInt16:
        return "uint16";
    case RegisterType::UInt32:
        return "uint32";
    case RegisterType::Bits:
        return "bits";
    case RegisterType::Float32:
        return "float32";
    }
    return "";
}

std::uint16_t registerChecksum(std::span<const std::uint16_t> registers)
{
    unsigned crc = 0xFFFF;
    const auto take = [&crc](unsigned byte) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xA001U : crc >> 1U;
    };
    for (const std::uint16_t value : registers) {
        take(value >> 8U);
        take(value & 0xFFU);
    }
    return static_cast<std::uint16_t>(crc);
}

namespace {

/// Words one behind the other, from a first address on.
class RegisterWriter {
public:
    RegisterWriter(std::span<std::uint16_t> words, int first) : m_words(words), m_first(first) {}
    void put16(int address, unsigned value)
    {
        m_words[static_cast<std::size_t>(address - m_first)] = static_cast<std::uint16_t>(value);
    }
    void put32(int address, std::uint32_t value)
    {
        put16(address, value >> 16U);
        put16(address + 1, value & 0xFFFFU);
    }
    void putFloat(int address, double value)
    {
        const auto narrow = static_cast<float>(value);
        put32(address, std::bit_cast<std::uint32_t>(std::isfinite(narrow) ? narrow : 0.0F));
    }

private:
    std::span<std::uint16_t> m_words;
    int m_first;
};

unsigned statusBits(const JobDesk::View& view)
{
    using namespace line_status_bit;
    unsigned bits = 0;
    bits |= view.wouldTake ? ready : 0U;
    bits |= view.busy ? busy : 0U;
    bits |= view.unread ? resultValid : 0U;
    bits |= view.station.armed ? armed : 0U;
    bits |= view.station.simulated ? simulated : 0U;
    bits |= view.plcAlive ? plcAlive : 0U;
    return bits;
}

void putStatus(RegisterWriter& to, const JobDesk::View& view)
{
    to.put16(100, line_register::mapVersion);
    to.put16(101, static_cast<unsigned>(view.state));
    to.put16(102, statusBits(view));
    to.put16(103, view.stationBeat);
    to.put16(104, view.lastTrigger);
    to.put16(105, static_cast<unsigned>(view.lastAnswer));
    to.put32(106, view.overruns);
    to.put32(108, view.refused);
    to.put32(110, view.outOfStep);
    to.put32(112, view.run);
}

unsigned putQuantities(RegisterWriter& to, const LineResult& result)
{
    unsigned known = 0;
    for (std::size_t i = 0; i < result.quantities.size(); ++i) {
        const std::optional<LineQuantity>& quantity = result.quantities[i];
        if (!quantity)
            continue;
        const int address = 130 + 4 * static_cast<int>(i);
        to.putFloat(address, quantity->value);
        to.putFloat(address + 2, quantity->standardUncertainty.value_or(0));
        known |= unsigned(line_result_bit::quantityKnown) << i;
        if (quantity->standardUncertainty)
            known |= unsigned(line_result_bit::uncertaintyKnown) << i;
    }
    return known;
}

void putResult(RegisterWriter& to, const LineResult& result)
{
    to.put32(120, result.sequence);
    to.put32(122, result.job.partToken);
    to.put16(124, result.job.trigger);
    to.put16(125, static_cast<unsigned>(result.state));
    to.put16(126, static_cast<unsigned>(result.evaluation));
    to.put16(127, (result.partial ? line_result_bit::partial : 0U) |
                      (result.simulated ? line_result_bit::simulated : 0U) | putQuantities(to, result));
    to.put16(128, result.job.type);
    to.put16(129, result.typeFound);
    const qint64 milliseconds = result.utc.isValid() ? result.utc.toMSecsSinceEpoch() : 0;
    to.put32(142, static_cast<std::uint32_t>(milliseconds / 1000));
    to.put16(144, static_cast<unsigned>(milliseconds % 1000));
    to.put16(145, static_cast<unsigned>(result.reason));
}

/// Whether registers `first` on are all of a block.
bool isWithin(int first, std::size_t count, int blockFirst, int blockCount)
{
    return first >= blockFirst && first + static_cast<int>(count) <= blockFirst + blockCount;
}

} // namespace

std::vector<std::uint16_t> encodeView(const JobDesk::View& view)
{
    using namespace line_register;
    std::vector<std::uint16_t> words(statusCount, 0);
    RegisterWriter to(words, statusFirst);
    putStatus(to, view);
    const std::vector<std::uint16_t> result = encodeResult(view.result);
    words.insert(words.end(), result.begin(), result.end());
    return words;
}

std::vector<std::uint16_t> encodeResult(const std::optional<LineResult>& result)
{
    using namespace line_register;
    std::vector<std::uint16_t> words(resultCount, 0);
    RegisterWriter to(words, resultFirst);
    if (result)
        putResult(to, *result);
    to.put16(checksum, registerChecksum(std::span(words).first(resultCount - 1)));
    return words;
}

std::optional<LineCommands> decodeWrite(int first, std::span<const std::uint16_t> values)
{
    using namespace line_register;
    const int last = first + static_cast<int>(values.size()) - 1;
    const auto at = [&](int address) { return values[static_cast<std::size_t>(address - first)]; };
    const auto at32 = [&](int address) {
        return (std::uint32_t(at(address)) << 16U) | std::uint32_t(at(address + 1));
    };
    const auto touches = [&](int from, int to) { return first <= to && last >= from; };
    const auto covers = [&](int from, int to) { return first <= from && last >= to; };
    LineCommands commands;
    if (covers(heartbeat, heartbeat))
        commands.beat = at(heartbeat);
    if (covers(acknowledge, acknowledge + 1))
        commands.release = at32(acknowledge);
    else if (touches(acknowledge, acknowledge + 1))
        return {};
    if (covers(trigger, partToken + 1))
        commands.job = LineJob{at(trigger), at(type), at32(partToken)};
    else if (touches(trigger, partToken + 1))
        return {};
    if (touches(wanted, wanted + 1) && !covers(wanted, wanted + 1))
        return {};
    return commands;
}

std::optional<ModbusException> LineRegisters::read(int first, std::span<std::uint16_t> values)
{
    using namespace line_register;
    if (isWithin(first, values.size(), commandFirst, commandCount)) {
        std::copy_n(m_written.begin() + (first - commandFirst), values.size(), values.begin());
        return {};
    }
    if (isWithin(first, values.size(), wantedFirst, resultCount)) {
        const std::uint32_t sequence = (std::uint32_t(m_written[wanted]) << 16U) | m_written[wanted + 1];
        const std::vector<std::uint16_t> result =
            encodeResult(m_desk->with([sequence](const JobDesk& desk) { return desk.resultById(sequence); }));
        std::copy_n(result.begin() + (first - wantedFirst), values.size(), values.begin());
        return {};
    }
    if (!isWithin(first, values.size(), statusFirst, statusCount + resultCount))
        return ModbusException::IllegalAddress;
    const JobDesk::View view =
        m_desk->with([](const JobDesk& desk) { return desk.view(std::chrono::steady_clock::now()); });
    const std::vector<std::uint16_t> all = encodeView(view);
    std::copy_n(all.begin() + (first - statusFirst), values.size(), values.begin());
    return {};
}

std::optional<ModbusException> LineRegisters::write(int first, std::span<const std::uint16_t> values)
{
    using namespace line_register;
    if (!isWithin(first, values.size(), commandFirst, commandCount))
        return ModbusException::IllegalAddress;
    const std::optional<LineCommands> commands = decodeWrite(first, values);
    if (!commands)
        return ModbusException::IllegalValue;
    std::copy(values.begin(), values.end(), m_written.begin() + (first - commandFirst));
    m_desk->with([&](JobDesk& desk) {
        const auto now = std::chrono::steady_clock::now();
        if (commands->beat)
            desk.beat(*commands->beat, now);
        if (commands->release)
            static_cast<void>(desk.releaseResult(*commands->release));
        if (commands->job)
            desk.startSingleJob(*commands->job, now);
    });
    return {};
}

} // namespace gripscope
