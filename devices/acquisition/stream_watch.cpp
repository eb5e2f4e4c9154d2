// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/stream_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// The least lateness of a window varies by this much: a frame of the bus and the waking of a thread.
constexpr double leastUncertainty_s = 0.002;
/// The stretch that is right among those that differ is known less well than the whole itself.
constexpr double overApart = 1.5;

} // namespace

void ClockComparison::take(std::int64_t arrival_ns, double device_s, double period_s)
{
    if (!m_started) {
        m_started = true;
        m_first_ns = arrival_ns;
        m_first_s = device_s;
        m_windowEnd_ns = arrival_ns + m_window_ns;
    }
    m_period_s = std::max(m_period_s, period_s);
    if (m_open && arrival_ns >= m_windowEnd_ns) {
        close();
        m_windowEnd_ns = arrival_ns + m_window_ns;
    }
    const double arrival_s = 1e-9 * static_cast<double>(arrival_ns - m_first_ns);
    const double lateness_s = arrival_s - (device_s - m_first_s);
    if (!m_open || lateness_s < m_open->lateness_s)
        m_open = Window{arrival_s, lateness_s};
}

void ClockComparison::close()
{
    if (m_count == most)
        makeRoom();
    m_closed[m_count++] = *m_open;
    m_open.reset();
    if (m_count >= fewest)
        compare();
}

void ClockComparison::makeRoom()
{
    if (m_window_ns >= longestWindow_ns) { // the older half is forgotten
        std::copy(m_closed.begin() + most / 2, m_closed.end(), m_closed.begin());
        m_count = most / 2;
        return;
    }
    const double slope = slopeOf(std::span(m_closed).first(m_count)).lateness;
    const auto late = [slope](const Window& window) { return window.lateness_s - slope * window.arrival_s; };
    for (std::size_t i = 0; i < most / 2; ++i) {
        const Window &one = m_closed[2 * i], &other = m_closed[2 * i + 1];
        m_closed[i] = late(one) <= late(other) ? one : other;
    }
    m_count = most / 2;
    m_window_ns *= 2;
}

ClockComparison::Slope ClockComparison::slopeOf(std::span<const Window> windows)
{
    // Which one is least late depends on the slope: it settles in a few rounds.
    constexpr int rounds = 4;
    const std::size_t third = std::max<std::size_t>(1, windows.size() / 3);
    Slope slope;
    for (int round = 0; round < rounds; ++round) {
        const auto later = [&slope](const Window& one, const Window& other) {
            return one.lateness_s - slope.lateness * one.arrival_s <
                   other.lateness_s - slope.lateness * other.arrival_s;
        };
        const auto first = windows.first(third), last = windows.last(third);
        const Window& begin = *std::min_element(first.begin(), first.end(), later);
        const Window& end = *std::min_element(last.begin(), last.end(), later);
        slope.seconds = end.arrival_s - begin.arrival_s;
        if (!(slope.seconds > 0))
            return slope;
        slope.lateness = (end.lateness_s - begin.lateness_s) / slope.seconds;
    }
    return slope;
}

void ClockComparison::compare()
{
    const std::span<const Window> all = std::span(m_closed).first(m_count);
    const Slope whole = slopeOf(all);
    m_difference.reset();
    if (!(whole.seconds > 0))
        return;
    const std::size_t half = m_count / 2;
    double apart = 0;
    for (const std::size_t first : {std::size_t(0), half / 2, m_count - half})
        apart = std::max(apart, std::abs(slopeOf(all.subspan(first, half)).lateness - whole.lateness));
    const double lateness_s = std::max(leastUncertainty_s, 2 * m_period_s);
    // Who runs fast is less and less late.
    m_difference =
        RateDifference{-1e6 * whole.lateness, 1e6 * (lateness_s / whole.seconds + overApart * apart)};
}

namespace {

std::int64_t nanosecondsOf(StreamWatch::Clock::time_point t)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(t.time_since_epoch()).count();
}

void countUp(std::uint8_t& count, std::uint64_t by = 1)
{
    count = static_cast<std::uint8_t>(std::min<std::uint64_t>(255, count + by));
}

} // namespace

void StreamWatch::begin(double sampleTime_s, bool streamsAlways, bool timed)
{
    m_sampleTime_s = sampleTime_s;
    m_streamsAlways = streamsAlways;
    m_timed.store(timed, std::memory_order_relaxed);
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
        m_clock.restart();
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
    if (m_timed.load(std::memory_order_relaxed))
        compareClocks(first, batch.size(), now);
}

void StreamWatch::compareClocks(const Sample& first, std::size_t samples, Clock::time_point now)
{
    const double period_s = static_cast<double>(samples) * m_sampleTime_s;
    m_clock.take(nanosecondsOf(now), first.time_s, period_s);
    share(m_clockRate, m_clock);
    m_sampling.take(nanosecondsOf(now), static_cast<double>(first.sequence) * m_sampleTime_s, period_s);
    share(m_samplingRate, m_sampling);
}

void StreamWatch::share(std::atomic<SharedRate>& rate, const ClockComparison& comparison)
{
    SharedRate shared;
    if (const std::optional<RateDifference>& found = comparison.difference())
        shared = {static_cast<float>(found->ppm), static_cast<float>(found->uncertainty_ppm)};
    rate.store(shared, std::memory_order_relaxed);
}

std::optional<RateDifference> StreamWatch::known(const std::atomic<SharedRate>& rate)
{
    const SharedRate shared = rate.load(std::memory_order_relaxed);
    if (std::isnan(shared.ppm))
        return std::nullopt;
    return RateDifference{static_cast<double>(shared.ppm), static_cast<double>(shared.uncertainty_ppm)};
}

void StreamWatch::publish(const ReportDecoder::Counts& counts, Clock::time_point now)
{
    if (counts.lostSamples != m_lostSamples.load(std::memory_order_relaxed))
        m_lastLoss_ns.store(nanosecondsOf(now), std::memory_order_relaxed);
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
    counters.clocks = {m_timed.load(), known(m_clockRate), known(m_samplingRate)};
    if (const std::int64_t lastLoss_ns = m_lastLoss_ns.load(); lastLoss_ns != 0)
        counters.lastLoss = Clock::time_point(
            std::chrono::duration_cast<Clock::duration>(std::chrono::nanoseconds(lastLoss_ns)));
}

} // namespace gripscope
