// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>

#include <cstdint>
#include <random>

namespace gripscope {

/// Random numbers that are the same on every machine: a standard generator under Boost's distributions (those
/// of the standard library differ from one library to the next). Streams with different (seed, squeeze,
/// purpose) are independent for all that matters here: the three are mixed by the finaliser of SplitMix64
/// (Steele, Lea and Flood 2014) before they seed the generator.
class RandomStream {
public:
    RandomStream(std::uint64_t seed, std::uint64_t squeeze, std::uint64_t purpose)
        : m_generator(mix(mix(mix(seed) + squeeze) + purpose))
    {
    }

    [[nodiscard]] double normal() { return m_normal(m_generator); }   ///< mean 0, standard deviation 1
    [[nodiscard]] double uniform() { return m_uniform(m_generator); } ///< [0, 1)
    [[nodiscard]] std::uint64_t bits() { return m_generator(); }

private:
    static std::uint64_t mix(std::uint64_t x)
    {
        x += 0x9E3779B97F4A7C15ULL;
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
        return x ^ (x >> 31);
    }
    std::mt19937_64 m_generator;
    boost::random::normal_distribution<double> m_normal;
    boost::random::uniform_01<double> m_uniform;
};

} // namespace gripscope
