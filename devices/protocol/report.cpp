// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/report.h"

#include "devices/protocol/byte_order.h"

#include <boost/crc.hpp>

#include <algorithm>

namespace gripscope::protocol {

namespace {
constexpr std::size_t crcOffset = reportSize - 2;
}

std::uint16_t crc16(ReportView bytes)
{
    boost::crc_ccitt_type crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return static_cast<std::uint16_t>(crc.checksum());
}

std::optional<DecodeError> checkReport(ReportView bytes)
{
    if (bytes.size() != reportSize)
        return DecodeError(DecodeError::Length, bytes.size());
    if (load<std::uint16_t>(bytes, crcOffset) != crc16(bytes.first(crcOffset)))
        return DecodeError::Crc;
    if (bytes[1] >> 4 != versionMajor)
        return DecodeError(DecodeError::Version, bytes[1]);
    return std::nullopt;
}

void seal(Report& report, std::uint8_t minor)
{
    report[1] = static_cast<std::uint8_t>(versionMajor << 4 | (minor & 0x0F));
    store(report, crcOffset, crc16(ReportView(report).first(crcOffset)));
}

std::string loadText(ReportView bytes, std::size_t offset, std::size_t size)
{
    const ReportView field = bytes.subspan(offset, size);
    const auto end = std::find(field.begin(), field.end(), std::uint8_t(0));
    return std::string(field.begin(), end);
}

void storeText(Report& report, std::size_t offset, std::size_t size, std::string_view text)
{
    std::size_t count = std::min(size, text.size());
    const auto continues = [&](std::size_t i) { return (static_cast<std::uint8_t>(text[i]) & 0xC0) == 0x80; };
    while (count > 0 && count < text.size() && continues(count))
        --count;
    std::fill_n(report.begin() + static_cast<std::ptrdiff_t>(offset), size, std::uint8_t(0));
    std::copy_n(text.begin(), count, report.begin() + static_cast<std::ptrdiff_t>(offset));
}

} // namespace gripscope::protocol
