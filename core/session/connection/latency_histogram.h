// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace gripscope {

/// How long things took during the last ten seconds, as a histogram of fixed size: bins of 0.25 ms up to 64
/// ms, above that an eighth wide of their value, the last from 10 s on. No allocation; adding costs
/// nanoseconds. Belongs to one thread.
class LatencyHistogram {
public:
    using TimePoint = std::chrono::steady_clock::time_point;

    void add(double milliseconds, TimePoint now, std::uint32_t times = 1);
    void clear() { *this = {}; }
    /// The time that `share` of all stayed below (the upper end of its bin); 0 when nothing was added.
    [[nodiscard]] double quantile_ms(double share, TimePoint now) const;

private:
    static constexpr std::size_t seconds = 10; ///< a second each
    static constexpr std::size_t linearBins = 256, bins = linearBins + 44;
    [[nodiscard]] static std::size_t binOf(double milliseconds);
    [[nodiscard]] static double upperEnd_ms(std::size_t bin);

    struct Slot {
        std::int64_t second = -1;
        std::array<std::uint32_t, bins> counts{};
    };
    std::array<Slot, seconds> m_slots{};
};

} // namespace gripscope
