// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/stream_assembler.h"

namespace gripscope::protocol {

namespace {
constexpr std::uint32_t furthestDuplicate = 64; ///< as many reports as the kernel's ring holds

/// The 64-bit value next to `near` whose low half is `low`, at most 2^31 away; never below zero.
std::uint64_t continueCount(std::uint64_t near, std::uint32_t low)
{
    const auto step = static_cast<std::int32_t>(low - static_cast<std::uint32_t>(near));
    if (step < 0 && near < static_cast<std::uint64_t>(-static_cast<std::int64_t>(step)))
        return low;
    return near + static_cast<std::uint64_t>(static_cast<std::int64_t>(step));
}
} // namespace

StreamAssembler::Outcome StreamAssembler::take(const StreamReport& report, std::vector<Sample>& samples)
{
    if (!m_started) {
        m_started = true;
        m_nextSample = report.firstSample;
        m_timestamp_us = report.timestamp_us;
    } else {
        const auto ahead = static_cast<std::int32_t>(report.reportSequence - m_lastReport);
        if (ahead <= 0 && ahead >= -static_cast<std::int32_t>(furthestDuplicate)) {
            ++m_duplicateReports;
            return Outcome::Duplicate;
        }
        const std::uint64_t first = continueCount(m_nextSample, report.firstSample);
        const std::uint64_t timestamp = continueCount(m_timestamp_us, report.timestamp_us);
        // Time and samples run forward only; whatever else they do, the device has begun to count anew.
        if (ahead < 0 || first < m_nextSample || timestamp < m_timestamp_us)
            return Outcome::Restarted;
        m_lostSamples += first - m_nextSample;
        m_nextSample = first;
        m_timestamp_us = timestamp;
    }
    m_lastReport = report.reportSequence;
    for (std::size_t i = 0; i < report.count; ++i) {
        const RawSample& raw = report.samples[i];
        samples.push_back(
            {m_nextSample++,
             1e-6 * static_cast<double>(m_timestamp_us) + static_cast<double>(i) * m_sampleTime_s,
             raw.force * m_forcePerCount, raw.position * m_positionPerCount, report.status});
    }
    return Outcome::Accepted;
}

} // namespace gripscope::protocol
