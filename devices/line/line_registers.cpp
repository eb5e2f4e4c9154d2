// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/line_registers.h"

#include <algorithm>

namespace gripscope {

namespace {

/// Whether registers `first` on are all of a block.
bool isWithin(int first, std::size_t count, int blockFirst, int blockCount)
{
    return first >= blockFirst && first + static_cast<int>(count) <= blockFirst + blockCount;
}

} // namespace

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
