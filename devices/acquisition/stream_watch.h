// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "core/signal/recording/stream_account.h"
#include "devices/transport/report_decoder.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace gripscope {

/// How fast a device's time runs beside the computer's, from the times of its reports and of their arrival.
///
/// A report arrives late, never early, and a reader that was held up ends with a report that is fresh. So
/// only the least late report of each window of time counts (125 ms, 250 ms once the connection is 16 s old;
/// the last 16 to 32 s). The rate is the slope between the two least late ones of the first and of the last
/// third, seen along that slope.
///
/// Its uncertainty has two parts. What the least lateness may differ by: 2 ms, and two report periods where
/// that is more (a host that asks about as often as the device sends beats with it), over the time between
/// the two. And how far the slopes of three stretches of half the length are off: a computer that was busy
/// until some moment and idle afterwards shifts the slope of the whole, but of those three at least one lies
/// on one side of that moment.
///
/// No allocation; one thread.
class ClockComparison {
public:
    /// Reports come `period_s` apart.
    void take(std::int64_t arrival_ns, double device_s, double period_s);
    /// Forgets all: the device's time was set.
    void restart() { *this = {}; }
    /// Of the device's time against the computer's; after a second.
    [[nodiscard]] const std::optional<RateDifference>& difference() const { return m_difference; }

private:
    struct Window {
        double arrival_s = 0, lateness_s = 0; ///< of its least late report; both from the first report on
    };
    /// Lateness along the clock's own slope, a slope for each second.
    struct Slope {
        double lateness = 0;
        double seconds = 0; ///< between the two reports it is from
    };
    static constexpr std::size_t most = 128;
    static constexpr std::size_t fewest = 8;
    static constexpr std::int64_t firstWindow_ns = 125'000'000, longestWindow_ns = 250'000'000;

    void close();
    void makeRoom();
    void compare();
    [[nodiscard]] static Slope slopeOf(std::span<const Window> windows);

    std::array<Window, most> m_closed{};
    std::size_t m_count = 0;
    std::int64_t m_first_ns = 0, m_windowEnd_ns = 0, m_window_ns = firstWindow_ns;
    double m_first_s = 0, m_period_s = 0;
    bool m_started = false;
    std::optional<Window> m_open;
    std::optional<RateDifference> m_difference;
};

/// A RateDifference that is read and written at once; not a number: not known.
struct SharedRate {
    float ppm = std::numeric_limits<float>::quiet_NaN();
    float uncertainty_ppm = 0;
};
static_assert(std::atomic<SharedRate>::is_always_lock_free);

/// What goes wrong in a stream, counted as it comes and written on the next sample that follows it, so that a
/// recording tells what happened during its squeeze. The reading thread calls everything but fill(), which
/// any thread may call; nobody waits.
class StreamWatch {
public:
    using Clock = std::chrono::steady_clock;
    /// A stall: no report for 50 ms (the device's watchdog allows 100) and for 20 report periods.
    static constexpr std::chrono::milliseconds leastStall{50};
    static constexpr double stallPeriods = 20;

    /// `timed`: the device's time runs beside the computer's, so that the two can be compared.
    void begin(double sampleTime_s, bool streamsAlways, bool timed);
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
    void compareClocks(const Sample& first, std::size_t samples, Clock::time_point now);

    static void share(std::atomic<SharedRate>& rate, const ClockComparison& comparison);
    [[nodiscard]] static std::optional<RateDifference> known(const std::atomic<SharedRate>& rate);

    Marks m_marks;
    ClockComparison m_clock;    ///< of the device's time stamps
    ClockComparison m_sampling; ///< of its sample count, which no jump of its clock disturbs
    std::optional<Clock::time_point> m_lastStream;
    double m_sampleTime_s = 0;
    Clock::duration m_stallLimit = leastStall;
    bool m_streamsAlways = true;
    std::atomic<bool> m_timed{false};

    std::atomic<std::uint64_t> m_reports{0}, m_badReports{0}, m_lostSamples{0}, m_sequenceGaps{0},
        m_duplicateReports{0}, m_clockSteps{0}, m_stalls{0};
    std::atomic<std::int64_t> m_lastLoss_ns{0}; ///< 0: none
    std::atomic<double> m_longestStall_s{0};
    std::atomic<SharedRate> m_clockRate{}, m_samplingRate{};
    std::atomic<bool> m_stalled{false};
};

} // namespace gripscope
