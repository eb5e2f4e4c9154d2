// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/sorted_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace gripscope {

namespace {

constexpr std::size_t fewToSort = 4096; // comparing is as fast there
constexpr int digitBits = 11, digitCount = 6;
constexpr std::size_t digitValues = std::size_t(1) << digitBits;
using DigitCounts = std::array<std::array<std::uint32_t, digitValues>, digitCount>;

constexpr std::uint64_t signBit = std::uint64_t(1) << 63;

/// Whole numbers that ascend as the values do.
std::uint64_t orderedBits(double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return (bits & signBit) != 0 ? ~bits : bits | signBit;
}

double valueOfBits(std::uint64_t ordered)
{
    return std::bit_cast<double>((ordered & signBit) != 0 ? ordered & ~signBit : ~ordered);
}

std::size_t digitOf(std::uint64_t bits, int digit)
{
    return std::size_t(bits >> (digit * digitBits)) & (digitValues - 1);
}

void sortByDigit(const std::vector<std::uint64_t>& from, std::vector<std::uint64_t>& into, int digit,
                 std::array<std::uint32_t, digitValues>& counts)
{
    std::uint32_t place = 0;
    for (std::uint32_t& count : counts)
        place += std::exchange(count, place);
    for (const std::uint64_t bits : from)
        into[counts[digitOf(bits, digit)]++] = bits;
}

} // namespace

std::vector<double> sortedValues(std::span<const double> values)
{
    std::vector<double> sorted(values.begin(), values.end());
    if (values.size() < fewToSort || values.size() > UINT32_MAX) {
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    }
    std::vector<std::uint64_t> keys(values.size()), other(values.size());
    DigitCounts counts{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        keys[i] = orderedBits(values[i]);
        for (int digit = 0; digit < digitCount; ++digit)
            ++counts[std::size_t(digit)][digitOf(keys[i], digit)];
    }
    for (int digit = 0; digit < digitCount; ++digit) {
        auto& own = counts[std::size_t(digit)];
        if (own[digitOf(keys.front(), digit)] == keys.size())
            continue; // the same in all
        sortByDigit(keys, other, digit, own);
        std::swap(keys, other);
    }
    std::transform(keys.begin(), keys.end(), sorted.begin(), valueOfBits);
    return sorted;
}

} // namespace gripscope
