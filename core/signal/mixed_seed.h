// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace gripscope {

/// The finalizer of splitmix64 (Steele, Lea, Flood 2014): neighbouring numbers become unrelated seeds.
[[nodiscard]] constexpr std::uint64_t mixedSeed(std::uint64_t value)
{
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27U)) * 0x94d049bb133111ebu;
    return value ^ (value >> 31U);
}

} // namespace gripscope
