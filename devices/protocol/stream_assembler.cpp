// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/stream_assembler.h"

#include "core/signal/preparation/sample_clock.h"

#include <algorithm>
#include <cmath>

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

bool StreamAssembler::followClock(const StreamReport& report)
{
    if (!m_stampedSample) {
        m_time_us = m_stamp_us = report.timestamp_us;
        m_stampedSample = m_nextSample;
        m_stampedCount = report.count;
        return false;
    }
    const auto samples = static_cast<double>(m_nextSample - *m_stampedSample);
    const auto elapsed_us = static_cast<std::int32_t>(report.timestamp_us - m_stamp_us);
    const bool stepped = stepsContradict(1e-6 * elapsed_us / m_sampleTime_s, samples);
    // The samples of the last report reach this far; what comes now must be later.
    const double reach_us = 1e6 * m_sampleTime_s * (m_stampedCount - 1);
    const bool forward = elapsed_us > 0 && elapsed_us > reach_us;
    if (stepped && !forward)
        m_time_us += static_cast<std::uint64_t>(std::llround(std::min(1e6 * m_sampleTime_s * samples, 1e15)));
    else
        m_time_us += static_cast<std::uint64_t>(elapsed_us);
    m_clockSteps += stepped ? 1 : 0;
    m_stamp_us = report.timestamp_us;
    m_stampedSample = m_nextSample;
    m_stampedCount = report.count;
    return stepped;
}

StreamAssembler::Outcome StreamAssembler::take(const StreamReport& report, std::vector<Sample>& samples)
{
    if (!m_started) {
        m_started = true;
        m_nextSample = report.firstSample;
    } else {
        const auto ahead = static_cast<std::int32_t>(report.reportSequence - m_lastReport);
        if (ahead <= 0 && ahead >= -static_cast<std::int32_t>(furthestDuplicate)) {
            ++m_duplicateReports;
            return Outcome::Duplicate;
        }
        const std::uint64_t first = continueCount(m_nextSample, report.firstSample);
        // Samples are counted forward only; whatever else they do, the device has begun to count anew.
        if (ahead < 0 || first < m_nextSample)
            return Outcome::Restarted;
        m_lostSamples += first - m_nextSample;
        m_sequenceGaps += first != m_nextSample ? 1 : 0;
        m_nextSample = first;
    }
    m_lastReport = report.reportSequence;
    if (report.count == 0)
        return Outcome::Accepted;
    const bool stepped = followClock(report);
    for (std::size_t i = 0; i < report.count; ++i) {
        const RawSample& raw = report.samples[i];
        Sample& sample = samples.emplace_back(); // filled in place: a copy waits for its narrow stores
        sample.sequence = m_nextSample++;
        sample.time_s = 1e-6 * static_cast<double>(m_time_us) + static_cast<double>(i) * m_sampleTime_s;
        sample.force = raw.force * m_forcePerCount;
        sample.position = raw.position * m_positionPerCount;
        sample.status = report.status;
        sample.clockStepped = stepped && i == 0;
    }
    return Outcome::Accepted;
}

} // namespace gripscope::protocol
