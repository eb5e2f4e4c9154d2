// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/report_log.h"

#include <algorithm>

namespace gripscope {

void ReportLog::add(ReportDirection direction, std::span<const std::uint8_t> bytes, bool taken) noexcept
{
    const std::uint64_t number = m_passed.fetch_add(1, std::memory_order_relaxed);
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    if (!lock.owns_lock()) {
        m_missed.fetch_add(1, std::memory_order_relaxed);
        return;
    }
    LoggedReport& slot = m_ring[m_kept++ % capacity];
    slot.number = number;
    slot.time = std::chrono::steady_clock::now();
    slot.direction = direction;
    slot.taken = taken;
    slot.size = static_cast<std::uint8_t>(std::min(bytes.size(), slot.bytes.size()));
    std::copy_n(bytes.begin(), slot.size, slot.bytes.begin());
}

std::vector<LoggedReport> ReportLog::last() const
{
    std::vector<LoggedReport> reports;
    reports.reserve(capacity); // so that nothing but copying is done under the lock
    const std::lock_guard lock(m_mutex);
    for (std::uint64_t i = m_kept - std::min<std::uint64_t>(m_kept, capacity); i < m_kept; ++i)
        reports.push_back(m_ring[i % capacity]);
    return reports;
}

} // namespace gripscope
