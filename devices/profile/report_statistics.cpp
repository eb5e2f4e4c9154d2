// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/report_statistics.h"

#include <algorithm>

namespace gripscope {

void ReportStatistics::take(protocol::ReportView report, double time_s)
{
    if (m_reports == 0) {
        m_first_s = time_s;
        m_bytes.resize(report.size());
    }
    const std::size_t count = std::min(report.size(), m_bytes.size());
    for (std::size_t i = 0; i < count; ++i) {
        ByteStatistics& byte = m_bytes[i];
        if (m_reports == 0)
            byte.last = byte.least = byte.most = report[i];
        if (report[i] == byte.last)
            continue;
        byte.last = report[i];
        byte.least = std::min(byte.least, report[i]);
        byte.most = std::max(byte.most, report[i]);
        byte.lastChange_s = time_s;
        ++byte.changes;
    }
    m_last_s = time_s;
    ++m_reports;
}

std::vector<std::uint8_t> ReportStatistics::last() const
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(m_bytes.size());
    for (const ByteStatistics& byte : m_bytes)
        bytes.push_back(byte.last);
    return bytes;
}

double ReportStatistics::reportsPerSecond() const
{
    return seconds() > 0 ? static_cast<double>(m_reports - 1) / seconds() : 0;
}

double ReportStatistics::changesPerSecond(std::size_t byte) const
{
    return seconds() > 0 ? static_cast<double>(m_bytes[byte].changes) / seconds() : 0;
}

} // namespace gripscope
