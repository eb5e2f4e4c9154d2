// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace gripscope {

/// Reports and samples a second over about the last second, from their counters. No allocation; one thread.
class RateMeter {
public:
    using TimePoint = std::chrono::steady_clock::time_point;

    /// To be called often, also when nothing came.
    void take(TimePoint now, std::uint64_t reports, std::uint64_t samples);
    [[nodiscard]] double reportRate_Hz() const { return m_reportRate_Hz; }
    [[nodiscard]] double sampleRate_Hz() const { return m_sampleRate_Hz; }

private:
    static constexpr std::size_t marks = 11;
    static constexpr std::chrono::milliseconds spacing{100};
    struct Mark {
        TimePoint time;
        std::uint64_t reports = 0, samples = 0;
    };
    std::array<Mark, marks> m_marks{}; ///< a ring
    std::size_t m_count = 0;
    double m_reportRate_Hz = 0, m_sampleRate_Hz = 0;
};

} // namespace gripscope
