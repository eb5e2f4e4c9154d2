// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/latency_histogram.h"
#include "devices/acquisition/command_queue.h"
#include "devices/acquisition/rate_meter.h"
#include "devices/acquisition/report_decoder.h"
#include "devices/acquisition/sample_queue.h"
#include "devices/acquisition/stream_watch.h"

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace gripscope {

/// One connection to a gripper, from open to close or loss: the state that three threads share.
///
///   opener  opens the transport and asks what the device is, then ends; may take seconds
///   reader  turns reports into samples; the only one that pushes to the sample queue
///   writer  sends commands and the heartbeat; a stop goes before all else
///
/// One mutex guards everything but the sample queue and the counters; it is held for moments only and never
/// while a transport is being called. Threads hold the link by shared pointer, so that one that is stuck in a
/// system call can be left behind.
class DeviceLink {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds heartbeatPeriod{25};
    static constexpr std::chrono::milliseconds aliveFor{
        1000}; ///< heartbeats go on after the last confirmAlive()
    static constexpr std::chrono::milliseconds silenceLimit{
        1000}; ///< a device that says nothing is taken for lost
    static constexpr std::chrono::milliseconds readTimeout{20};

    DeviceLink(std::shared_ptr<Transport> transport, std::unique_ptr<ReportDecoder> decoder, QString address,
               std::size_t queueCapacity);

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
    struct Squeeze {
        SqueezeState state = SqueezeState::Idle;
        std::uint16_t number = 0;
        std::uint64_t samplesBefore = 0; ///< pushed up to its end: it shows as ended once they are drained
    };
    using Lock = std::unique_lock<std::mutex>;

    // All of these are called with the mutex held.
    void setState(LinkState state);
    void lose(Error error);
    void endReplay();
    void endSqueeze(SqueezeState state);
    void follow(std::uint16_t status, protocol::ExcitationState excitation, std::uint16_t number);
    void settle(const CommandQueue::Outcome& outcome);
    void refuse(const CommandQueue::Outcome& outcome);
    [[nodiscard]] bool live() const { return m_state == LinkState::Ready || m_state == LinkState::Armed; }
    [[nodiscard]] bool takesCommands() const { return live() && m_understandsCommands; }
    [[nodiscard]] bool heartbeatDue(Clock::time_point now) const;
    [[nodiscard]] std::optional<protocol::Report> nextReport(Clock::time_point now);
    [[nodiscard]] Clock::time_point writerWakesAt(Clock::time_point now) const;
    [[nodiscard]] bool silentFor(std::chrono::milliseconds limit, Clock::time_point now) const;

    // Reader's.
    [[nodiscard]] bool waitUntilOpened();
    void waitForRoom(); ///< in the sample queue, where the transport waits for its reader
    void take(protocol::ReportView bytes);
    void takeSamples(Clock::time_point now);                 ///< those of m_batch
    void takeState(const ReportDecoder::DeviceState& state); ///< called with the mutex held
    void takeAcknowledgement(const protocol::Acknowledgement& answer);
    /// A report whose samples were taken before the last answer was given may arrive after it; what it says
    /// of the device's state is old then. Called with the mutex held.
    [[nodiscard]] bool olderThanAnswer(const ReportDecoder::DeviceState& state);

    const std::shared_ptr<Transport> m_transport;
    const std::unique_ptr<ReportDecoder> m_decoder; ///< opener's, then reader's
    const bool m_understandsCommands;
    const QString m_address;

    mutable std::mutex m_mutex;
    std::condition_variable m_changed; ///< for opener, reader and writer
    LinkState m_state = LinkState::Opening;
    std::optional<Error> m_error;
    DeviceDescription m_device;
    CommandQueue m_commands;
    Squeeze m_squeeze;
    std::uint16_t m_nextExcitation = 1;
    bool m_armAnswered = false; ///< the device said itself that this program armed it
    Clock::time_point m_lastHeartbeat, m_lastReport;
    std::optional<Clock::time_point> m_unansweredSince;
    std::optional<std::uint32_t> m_lastAnswer_us; ///< device's clock; until a report is newer

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
