// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/rate_meter.h"

namespace gripscope {

void RateMeter::take(TimePoint now, std::uint64_t reports, std::uint64_t samples)
{
    if (m_count > 0 && now - m_marks[(m_count - 1) % marks].time < spacing)
        return;
    m_marks[m_count++ % marks] = {now, reports, samples};
    const Mark& oldest = m_marks[m_count < marks ? 0 : m_count % marks];
    const double seconds = std::chrono::duration<double>(now - oldest.time).count();
    if (!(seconds > 0))
        return;
    m_reportRate_Hz = static_cast<double>(reports - oldest.reports) / seconds;
    m_sampleRate_Hz = static_cast<double>(samples - oldest.samples) / seconds;
}

} // namespace gripscope
