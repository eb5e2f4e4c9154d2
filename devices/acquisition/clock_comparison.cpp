// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/clock_comparison.h"

#include <algorithm>

namespace gripscope {

void ClockComparison::take(std::int64_t arrival_ns, double device_s)
{
    if (!m_open && m_count == 0) {
        m_first_ns = arrival_ns;
        m_first_s = device_s;
        m_windowEnd_ns = arrival_ns + window_ns;
    }
    if (m_open && arrival_ns >= m_windowEnd_ns) {
        m_closed[m_count++ % windows] = *m_open;
        m_open.reset();
        m_windowEnd_ns = arrival_ns + window_ns;
    }
    const double arrival_s = 1e-9 * static_cast<double>(arrival_ns - m_first_ns);
    const double lateness_s = arrival_s - (device_s - m_first_s);
    if (!m_open || lateness_s < m_open->lateness_s)
        m_open = Window{arrival_s, lateness_s};
}

std::optional<double> ClockComparison::drift_ppm() const
{
    const std::size_t count = std::min(m_count, windows);
    if (count < fewest)
        return std::nullopt;
    double meanTime = 0, meanLateness = 0;
    for (std::size_t i = 0; i < count; ++i) {
        meanTime += m_closed[i].arrival_s / static_cast<double>(count);
        meanLateness += m_closed[i].lateness_s / static_cast<double>(count);
    }
    double together = 0, alone = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double time = m_closed[i].arrival_s - meanTime;
        together += time * (m_closed[i].lateness_s - meanLateness);
        alone += time * time;
    }
    if (!(alone > 0))
        return std::nullopt;
    return -1e6 * together / alone;
}

} // namespace gripscope
