// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_port.h"
#include "devices/acquisition/clock_comparison.h"
#include "devices/acquisition/report_decoder.h"

#include <atomic>
#include <span>

namespace gripscope {

/// What goes wrong in a stream, counted as it comes and written on the next sample that follows it, so that a
/// recording tells what happened during its squeeze. The reading thread calls everything but fill(), which
/// any thread may call; nobody waits.
class StreamWatch {
public:
    using Clock = std::chrono::steady_clock;
    /// A stall: no report for 50 ms (the device's watchdog allows 100) and for 20 report periods.
    static constexpr std::chrono::milliseconds leastStall{50};
    static constexpr double stallPeriods = 20;

    void begin(double sampleTime_s, bool streamsAlways);
    void reportCame() { m_reports.fetch_add(1, std::memory_order_relaxed); }
    void reportWasBad();
    /// A stream report was decoded into `batch`, which takes the marks; `counts` is all there was so far.
    void decoded(const ReportDecoder::Counts& counts, std::span<Sample> batch, Clock::time_point now);
    /// The wire is empty: what came last is all there is. Not to be called because the reader was late
    /// itself.
    void nothingCame(Clock::time_point now);

    void fill(LinkCounters& counters) const;

private:
    /// Pending for the next sample.
    struct Marks {
        std::uint8_t duplicates = 0, badReports = 0;
    };
    void publish(const ReportDecoder::Counts& counts, Clock::time_point now);
    [[nodiscard]] double endStall(Clock::time_point now);

    Marks m_marks;
    ClockComparison m_clocks;
    std::optional<Clock::time_point> m_lastStream;
    double m_sampleTime_s = 0;
    Clock::duration m_stallLimit = leastStall;
    bool m_streamsAlways = true;

    std::atomic<std::uint64_t> m_reports{0}, m_badReports{0}, m_lostSamples{0}, m_sequenceGaps{0},
        m_duplicateReports{0}, m_clockSteps{0}, m_stalls{0};
    std::atomic<std::int64_t> m_lastLoss_ns{0}; ///< 0: none
    std::atomic<double> m_longestStall_s{0};
    std::atomic<double> m_drift_ppm;
    std::atomic<bool> m_stalled{false}, m_driftKnown{false};
};

} // namespace gripscope
