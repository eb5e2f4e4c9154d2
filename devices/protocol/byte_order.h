// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/report.h"

#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace gripscope::protocol {

/// Little-endian numbers at a byte offset; the caller has checked the length.
template <typename T>
[[nodiscard]] T load(ReportView bytes, std::size_t offset)
{
    static_assert(std::is_integral_v<T>);
    std::make_unsigned_t<T> value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
        value = static_cast<std::make_unsigned_t<T>>(
            value | static_cast<std::make_unsigned_t<T>>(bytes[offset + i]) << (8 * i));
    return static_cast<T>(value);
}

template <typename T>
void store(Report& report, std::size_t offset, T value)
{
    static_assert(std::is_integral_v<T>);
    const auto bits = static_cast<std::make_unsigned_t<T>>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i)
        report[offset + i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

/// IEEE 754 double precision, little endian.
[[nodiscard]] inline double loadDouble(ReportView bytes, std::size_t offset)
{
    return std::bit_cast<double>(load<std::uint64_t>(bytes, offset));
}
inline void storeDouble(Report& report, std::size_t offset, double value)
{
    store(report, offset, std::bit_cast<std::uint64_t>(value));
}

/// Text in a field of `size` bytes, filled up with zero bytes; a longer text is cut between UTF-8 characters.
[[nodiscard]] std::string loadText(ReportView bytes, std::size_t offset, std::size_t size);
void storeText(Report& report, std::size_t offset, std::size_t size, std::string_view text);

} // namespace gripscope::protocol
