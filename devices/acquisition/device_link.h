// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/latency_histogram.h"
#include "devices/acquisition/link_control.h"
#include "devices/acquisition/sample_queue.h"
#include "devices/acquisition/stream_watch.h"
#include "devices/transport/report_decoder.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace gripscope {

/// Reports and samples a second over about the last second, from their counters. No allocation; one thread.
class RateMeter {
public:
    using TimePoint = std::chrono::steady_clock::time_point;

    /// To be called often, also when nothing came.
    void take(TimePoint now, std::uint64_t reports, std::uint64_t samples);
    [[nodiscard]] double reportRate_Hz() const { return m_reportRate_Hz; }
    [[nodiscard]] double sampleRate_Hz() const { return m_sampleRate_Hz; }

private:
    static constexpr std::size_t marks = 11;
    static constexpr std::chrono::milliseconds spacing{100};
    struct Mark {
        TimePoint time;
        std::uint64_t reports = 0, samples = 0;
    };
    std::array<Mark, marks> m_marks{}; ///< a ring
    std::size_t m_count = 0;
    double m_reportRate_Hz = 0, m_sampleRate_Hz = 0;
};

[[nodiscard]] inline std::int64_t nanoseconds(std::chrono::steady_clock::time_point t)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(t.time_since_epoch()).count();
}
[[nodiscard]] inline std::chrono::steady_clock::time_point timePoint(std::int64_t since_ns)
{
    return std::chrono::steady_clock::time_point(
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::nanoseconds(since_ns)));
}

/// One connection to a gripper, from open to close or loss: the state that three threads share.
///
///   opener  opens the transport and asks what the device is, then ends; may take seconds
///   reader  turns reports into samples; the only one that pushes to the sample queue
///   writer  sends commands and the heartbeat; a stop goes before all else
///
/// What is decided, and why, is in LinkControl. One mutex guards everything but the sample queue and the
/// counters; it is held for moments only and never while a transport is being called. Threads hold the link
/// by shared pointer, so that one that is stuck in a system call can be left behind.
class DeviceLink {
public:
    using Clock = std::chrono::steady_clock;
    /// Below LinkLimits::freshFor, so that a silence is seen soon after it is one.
    static constexpr std::chrono::milliseconds readTimeout{10};

    DeviceLink(std::shared_ptr<Transport> transport, std::unique_ptr<ReportDecoder> decoder, QString address,
               std::size_t queueCapacity, const LinkLimits& limits = {});

    // Bodies of the three threads.
    void runOpener();
    void runReader();
    void runWriter();

    // From the owner of the port.
    [[nodiscard]] LinkState state() const;
    [[nodiscard]] std::optional<Error> lastError() const;
    [[nodiscard]] GripperIdentity identity() const;
    [[nodiscard]] LinkCounters counters() const;
    [[nodiscard]] SqueezeState squeezeState() const;
    [[nodiscard]] StopState stopState() const;
    [[nodiscard]] std::optional<Error> disarmReason() const;
    std::size_t drain(std::vector<Sample>& samples, std::size_t most);
    void arm();
    void disarm();
    void startExcitation(const AdmittedExcitation& excitation);
    void confirmAlive() noexcept;
    void note(const QString& text);

    // From any thread.
    void finishExcitation();
    void stop() noexcept;
    void beginClosing();   ///< the writer sends a last stop where one is due, then ends
    void closeTransport(); ///< the reader ends
    void finishClosing();  ///< Closed, whatever became of the threads

private:
    using Lock = std::unique_lock<std::mutex>;

    // All of these are called with the mutex held.
    void setState(LinkState state);
    void lose(Error error);
    void endReplay();
    [[nodiscard]] bool live() const { return m_state == LinkState::Ready; }
    [[nodiscard]] bool takesCommands() const { return live() && m_understandsCommands; }
    [[nodiscard]] bool mayWrite(Clock::time_point now) const;
    [[nodiscard]] bool mayStopReading(Transport::Outcome last) const;
    [[nodiscard]] bool silentFor(std::chrono::milliseconds limit, Clock::time_point now) const;

    // Reader's.
    [[nodiscard]] bool waitUntilOpened();
    void waitForRoom(); ///< in the sample queue, where the transport waits for its reader
    void take(protocol::ReportView bytes);
    void takeSamples(Clock::time_point now); ///< those of m_batch
    void takeAcknowledgement(const protocol::Acknowledgement& answer);

    /// A wish of the owner, where commands are taken; then the writer is woken.
    template <typename Wish>
    void want(Wish wish)
    {
        {
            const Lock lock(m_mutex);
            if (!takesCommands())
                return;
            wish(m_control, Clock::now());
        }
        m_changed.notify_all();
    }

    const std::shared_ptr<Transport> m_transport;
    const std::unique_ptr<ReportDecoder> m_decoder; ///< opener's, then reader's
    const bool m_understandsCommands;
    const QString m_address;
    const LinkLimits m_limits;

    mutable std::mutex m_mutex;
    std::condition_variable m_changed; ///< for opener, reader and writer
    LinkState m_state = LinkState::Opening;
    std::optional<Error> m_error;
    GripperIdentity m_identity;
    mutable LinkControl m_control; ///< from Ready on; mutable: a stop's time runs out while it is asked for
    Clock::time_point m_lastReport;
    std::optional<Clock::time_point> m_unansweredSince;

    SampleQueue m_samples;
    std::vector<Sample> m_batch; ///< reader's own
    StreamWatch m_watch;         ///< reader's own, but for its counters
    std::atomic<std::int64_t> m_aliveAt_ns{0};
    std::atomic<std::int64_t> m_newestArrival_ns{0};
    std::atomic<std::uint64_t> m_droppedSamples{0};

    // Owner's own: how soon it takes over what arrived.
    void timeTakingOver(std::span<const Sample> taken, Clock::time_point now);
    LatencyHistogram m_latencies;
    RateMeter m_rates;
    std::optional<std::uint64_t> m_lastDrained; ///< sequence number; owner's own
    double m_latency_ms = 0;
    std::optional<Clock::time_point> m_takenArrival; ///< of the newest sample taken over
};

} // namespace gripscope
