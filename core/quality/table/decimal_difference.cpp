// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/table/decimal_difference.h"

#include <algorithm>
#include <cstdint>

namespace gripscope {

namespace {

constexpr int mostDigits = 18; // of an std::int64_t, with room for a difference

/// mantissa / 10^decimals.
struct WrittenDecimal {
    std::int64_t mantissa = 0;
    int digits = 0, decimals = 0;
};

std::optional<WrittenDecimal> writtenDecimal(std::string_view text)
{
    WrittenDecimal number;
    const bool negative = !text.empty() && text.front() == '-';
    if (!text.empty() && (negative || text.front() == '+'))
        text.remove_prefix(1);
    bool isFraction = false;
    for (const char c : text) {
        if (c == '.' && !isFraction) {
            isFraction = true;
            continue;
        }
        if (c < '0' || c > '9' || ++number.digits > mostDigits)
            return {};
        number.mantissa = 10 * number.mantissa + (c - '0');
        number.decimals += isFraction;
    }
    if (number.digits == 0)
        return {};
    number.mantissa = negative ? -number.mantissa : number.mantissa;
    return number;
}

/// False where more digits than can be held would be needed.
bool extendDecimals(WrittenDecimal& number, int decimals)
{
    for (; number.decimals < decimals; ++number.decimals) {
        if (++number.digits > mostDigits)
            return false;
        number.mantissa *= 10;
    }
    return true;
}

} // namespace

std::optional<double> decimalDifference(std::string_view a, std::string_view b)
{
    std::optional<WrittenDecimal> left = writtenDecimal(a), right = writtenDecimal(b);
    if (!left || !right)
        return {};
    const int decimals = std::max(left->decimals, right->decimals);
    if (!extendDecimals(*left, decimals) || !extendDecimals(*right, decimals))
        return {};
    double unit = 1; // a power of ten up to 10^18 is a double without rounding
    for (int i = 0; i < decimals; ++i)
        unit *= 10;
    return double(left->mantissa - right->mantissa) / unit;
}

} // namespace gripscope
