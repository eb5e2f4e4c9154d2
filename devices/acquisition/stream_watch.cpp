// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/stream_watch.h"

#include <algorithm>
#include <limits>

namespace gripscope {

namespace {

std::int64_t nanoseconds(StreamWatch::Clock::time_point t)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(t.time_since_epoch()).count();
}

void countUp(std::uint8_t& count, std::uint64_t by = 1)
{
    count = static_cast<std::uint8_t>(std::min<std::uint64_t>(255, count + by));
}

} // namespace

void StreamWatch::begin(double sampleTime_s, bool streamsAlways)
{
    m_sampleTime_s = sampleTime_s;
    m_streamsAlways = streamsAlways;
}

void StreamWatch::reportWasBad()
{
    m_badReports.fetch_add(1, std::memory_order_relaxed);
    countUp(m_marks.badReports);
}

void StreamWatch::decoded(const ReportDecoder::Counts& counts, std::span<Sample> batch, Clock::time_point now)
{
    countUp(m_marks.duplicates, counts.duplicateReports - m_duplicateReports.load(std::memory_order_relaxed));
    if (counts.clockSteps != m_clockSteps.load(std::memory_order_relaxed))
        m_clocks.restart();
    publish(counts, now);
    if (batch.empty())
        return;
    Sample& first = batch.front();
    const double stall_ms = 1000 * endStall(now);
    first.stall_ms =
        static_cast<std::uint16_t>(std::min<double>(stall_ms, std::numeric_limits<std::uint16_t>::max()));
    first.duplicates = m_marks.duplicates;
    first.badReports = m_marks.badReports;
    m_marks = {};
    m_lastStream = now;
    const auto period =
        std::chrono::duration<double>(stallPeriods * static_cast<double>(batch.size()) * m_sampleTime_s);
    m_stallLimit = std::max<Clock::duration>(leastStall, std::chrono::duration_cast<Clock::duration>(period));
    if (!m_streamsAlways)
        return; // its time does not run beside the computer's
    m_clocks.take(nanoseconds(now), first.time_s);
    if (const std::optional<double> drift = m_clocks.drift_ppm()) {
        m_drift_ppm.store(*drift, std::memory_order_relaxed);
        m_driftKnown.store(true, std::memory_order_release);
    }
}

void StreamWatch::publish(const ReportDecoder::Counts& counts, Clock::time_point now)
{
    if (counts.lostSamples != m_lostSamples.load(std::memory_order_relaxed))
        m_lastLoss_ns.store(nanoseconds(now), std::memory_order_relaxed);
    m_lostSamples.store(counts.lostSamples, std::memory_order_relaxed);
    m_sequenceGaps.store(counts.sequenceGaps, std::memory_order_relaxed);
    m_duplicateReports.store(counts.duplicateReports, std::memory_order_relaxed);
    m_clockSteps.store(counts.clockSteps, std::memory_order_relaxed);
}

void StreamWatch::nothingCame(Clock::time_point now)
{
    if (!m_streamsAlways || !m_lastStream || now - *m_lastStream < m_stallLimit)
        return;
    if (!m_stalled.exchange(true, std::memory_order_relaxed))
        m_stalls.fetch_add(1, std::memory_order_relaxed);
    const double seconds = std::chrono::duration<double>(now - *m_lastStream).count();
    m_longestStall_s.store(std::max(seconds, m_longestStall_s.load(std::memory_order_relaxed)),
                           std::memory_order_relaxed);
}

double StreamWatch::endStall(Clock::time_point now)
{
    if (!m_stalled.load(std::memory_order_relaxed))
        return 0;
    nothingCame(now); // its length, to the end
    m_stalled.store(false, std::memory_order_relaxed);
    return std::chrono::duration<double>(now - *m_lastStream).count();
}

void StreamWatch::fill(LinkCounters& counters) const
{
    counters.reports = m_reports.load();
    counters.badReports = m_badReports.load();
    counters.lostSamples = m_lostSamples.load();
    counters.sequenceGaps = m_sequenceGaps.load();
    counters.duplicateReports = m_duplicateReports.load();
    counters.clockSteps = m_clockSteps.load();
    counters.stalls = m_stalls.load();
    counters.longestStall_s = m_longestStall_s.load();
    counters.stalled = m_stalled.load();
    if (m_driftKnown.load(std::memory_order_acquire))
        counters.clockDrift_ppm = m_drift_ppm.load();
    if (const std::int64_t lastLoss_ns = m_lastLoss_ns.load(); lastLoss_ns != 0)
        counters.lastLoss = Clock::time_point(
            std::chrono::duration_cast<Clock::duration>(std::chrono::nanoseconds(lastLoss_ns)));
}

} // namespace gripscope
