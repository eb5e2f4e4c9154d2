// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/loss_watch.h"

namespace gripscope {

void LossWatch::look(const LinkCounters& counters, LinkCounters::TimePoint now)
{
    const Look newest{now, counters.samples, counters.lostSamples + counters.droppedSamples};
    if (!m_looks.empty() && (newest.samples < m_looks.back().samples || newest.lost < m_looks.back().lost))
        m_looks.clear();
    m_looks.push_back(newest);
    while (m_looks.size() > 2 && now - m_looks[1].at >= window)
        m_looks.pop_front();
}

double LossWatch::share() const
{
    if (m_looks.size() < 2)
        return 0;
    const std::uint64_t lost = m_looks.back().lost - m_looks.front().lost;
    const std::uint64_t came = m_looks.back().samples - m_looks.front().samples;
    return lost == 0 ? 0 : static_cast<double>(lost) / static_cast<double>(lost + came);
}

} // namespace gripscope
