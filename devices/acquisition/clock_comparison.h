// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace gripscope {

/// How fast a device's clock runs beside the computer's, from the times of its reports and of their arrival.
///
/// A report arrives late, never early, so the least lateness of each quarter of a second is taken, and a
/// straight line through those of the last 16 s gives the drift. No allocation; one thread.
class ClockComparison {
public:
    void take(std::int64_t arrival_ns, double device_s);
    /// Forgets all: the device's clock was set.
    void restart() { *this = {}; }
    /// Parts in a million by which the device's clock is fast (slow: below zero); after a second.
    [[nodiscard]] std::optional<double> drift_ppm() const;

private:
    static constexpr std::size_t windows = 64;
    static constexpr std::size_t fewest = 4;
    static constexpr std::int64_t window_ns = 250'000'000;
    struct Window {
        double arrival_s = 0, lateness_s = 0; ///< of its least late report; both from the first report on
    };
    std::array<Window, windows> m_closed{}; ///< a ring
    std::size_t m_count = 0;                ///< closed so far
    std::int64_t m_first_ns = 0, m_windowEnd_ns = 0;
    double m_first_s = 0;
    std::optional<Window> m_open;
};

} // namespace gripscope
