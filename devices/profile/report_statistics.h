// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/report.h"

#include <vector>

namespace gripscope {

/// What one byte of the reports did.
struct ByteStatistics {
    std::uint8_t last = 0, least = 0, most = 0;
    std::uint64_t changes = 0; ///< from one report to the next
    double lastChange_s = 0;   ///< meaningful when there was one
    [[nodiscard]] bool moves() const { return changes > 0; }
};

/// Reports of one length and ID, byte by byte.
class ReportStatistics {
public:
    /// `time_s` never decreases.
    void take(protocol::ReportView report, double time_s);

    [[nodiscard]] std::uint64_t reports() const { return m_reports; }
    [[nodiscard]] const std::vector<ByteStatistics>& bytes() const { return m_bytes; }
    [[nodiscard]] std::vector<std::uint8_t> last() const;
    [[nodiscard]] double seconds() const { return m_last_s - m_first_s; } ///< from the first to the last
    [[nodiscard]] double reportsPerSecond() const;
    [[nodiscard]] double changesPerSecond(std::size_t byte) const;

private:
    std::uint64_t m_reports = 0;
    double m_first_s = 0, m_last_s = 0;
    std::vector<ByteStatistics> m_bytes;
};

} // namespace gripscope
