// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/math/distributions.h"
#include "core/quality/charts/run_length.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

namespace gripscope {

namespace {

/// What the Western Electric rules remember, without what can no longer matter.
struct RememberedPoints {
    int run = 0;                                                     ///< in a row on one side, negative below
    unsigned aboveOne = 0, belowOne = 0, aboveTwo = 0, belowTwo = 0; ///< the newest as bit 0
    friend auto operator<=>(const RememberedPoints&, const RememberedPoints&) = default;
};

constexpr std::array<double, 6> zoneBorders{-3, -2, -1, 0, 1, 2}; // a zone goes up to the next, or 3

/// The bits, of at most `window` - 1 points, that can still be among `enough` of `window` in a row: of those
/// that are too old for that the oldest are let go.
unsigned stillCounting(unsigned bits, int window, int enough)
{
    bits &= (1U << (window - 1)) - 1;
    while (bits != 0) {
        // As many more points as the window leaves the oldest one would all have to count.
        const int age = std::bit_width(bits); // 1 for the newest
        if (std::popcount(bits) + (window - age) >= enough)
            return bits;
        bits &= ~(1U << (age - 1));
    }
    return 0;
}

/// Nothing: a signal.
std::optional<RememberedPoints> afterZone(const RememberedPoints& before, int zone)
{
    const double low = zoneBorders[std::size_t(zone)];
    const auto shifted = [](unsigned bits, bool counts) { return (bits << 1) | unsigned(counts); };
    const auto broken = [](unsigned bits, int window, int enough) {
        return (bits & 1U) && std::popcount(bits & ((1U << window) - 1)) >= enough;
    };
    RememberedPoints after;
    after.aboveOne = shifted(before.aboveOne, low >= 1);
    after.belowOne = shifted(before.belowOne, low <= -2);
    after.aboveTwo = shifted(before.aboveTwo, low >= 2);
    after.belowTwo = shifted(before.belowTwo, low <= -3);
    after.run = low >= 0 ? std::max(0, before.run) + 1 : std::min(0, before.run) - 1;
    if (broken(after.aboveTwo, 3, 2) || broken(after.belowTwo, 3, 2) || broken(after.aboveOne, 5, 4) ||
        broken(after.belowOne, 5, 4) || std::abs(after.run) >= 8)
        return {};
    after.aboveOne = stillCounting(after.aboveOne, 5, 4);
    after.belowOne = stillCounting(after.belowOne, 5, 4);
    after.aboveTwo = stillCounting(after.aboveTwo, 3, 2);
    after.belowTwo = stillCounting(after.belowTwo, 3, 2);
    return after;
}

using ZoneChances = std::array<double, 6>;

ZoneChances zoneChances(double shift)
{
    ZoneChances chances{};
    for (std::size_t i = 0; i < chances.size(); ++i)
        chances[i] = normalBelow(zoneBorders[i] + 1 - shift) - normalBelow(zoneBorders[i] - shift);
    return chances;
}

/// All that can be remembered, and where each zone leads; -1: to a signal.
std::vector<std::array<int, 6>> transitionsOfZones()
{
    std::map<RememberedPoints, int> places{{RememberedPoints(), 0}};
    std::vector<RememberedPoints> states{RememberedPoints()};
    std::vector<std::array<int, 6>> next;
    for (std::size_t from = 0; from < states.size(); ++from) {
        std::array<int, 6> row{};
        for (int zone = 0; zone < 6; ++zone) {
            const std::optional<RememberedPoints> after = afterZone(states[from], zone);
            if (!after) {
                row[std::size_t(zone)] = -1;
                continue;
            }
            const auto place = places.try_emplace(*after, int(states.size()));
            if (place.second)
                states.push_back(*after);
            row[std::size_t(zone)] = place.first->second;
        }
        next.push_back(row);
    }
    return next;
}

double westernElectricRunLength(double shift)
{
    static const std::vector<std::array<int, 6>> next = transitionsOfZones();
    const ZoneChances chances = zoneChances(shift);
    const Eigen::Index states = Eigen::Index(next.size());
    Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(states, states);
    for (Eigen::Index from = 0; from < states; ++from)
        for (std::size_t zone = 0; zone < chances.size(); ++zone)
            if (const int to = next[std::size_t(from)][zone]; to >= 0)
                equations(from, to) -= chances[zone];
    const Eigen::VectorXd lengths = equations.partialPivLu().solve(Eigen::VectorXd::Ones(states));
    return lengths(0);
}

RunLength simulatedRunLength(RunRules rules, double shift, int runs, std::uint64_t seed)
{
    RandomStream random(seed, 0, 0);
    double sum = 0, squares = 0;
    for (int run = 0; run < runs; ++run) {
        RunRuleWatch watch(rules);
        double length = 1;
        while (watch.add(random.normal() + shift) == 0)
            ++length;
        sum += length;
        squares += length * length;
    }
    const double mean = sum / runs;
    const double variance = std::max(0.0, squares / runs - mean * mean);
    return {mean, std::sqrt(variance / runs)};
}

} // namespace

RunLength shewhartRunLength(RunRules rules, double shift, int runs, std::uint64_t seed)
{
    switch (rules) {
    case RunRules::None:
        break;
    case RunRules::WesternElectric:
        return {westernElectricRunLength(shift), 0};
    case RunRules::Nelson:
        return simulatedRunLength(rules, shift, std::max(2, runs), seed);
    }
    return {1 / (normalAbove(3 - shift) + normalAbove(3 + shift)), 0};
}

} // namespace gripscope
