// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <random>

namespace gripscope {

/// Independent numbers of the standard normal distribution (mean 0, variance 1) that depend on the seed
/// alone. std::normal_distribution may differ from one standard library to the next; this is the 64-bit
/// Mersenne Twister, whose output the standard fixes, through the polar form of Box and Muller (Knuth,
/// TAOCP 3.4.1 C).
class GaussianNoise {
public:
    explicit GaussianNoise(std::uint64_t seed) : m_engine(seed) {}

    /// The next standard normal number.
    double operator()();
    /// Uniform on [0, 1), with 53 bits.
    double uniform();

private:
    std::mt19937_64 m_engine;
    std::optional<double> m_spare; ///< the method makes two at a time
};

} // namespace gripscope
