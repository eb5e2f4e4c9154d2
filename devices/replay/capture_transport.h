// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/capture_reader.h"
#include "devices/replay/capture_writer.h"
#include "devices/transport/transport.h"

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace gripscope {

/// Any transport, with a capture of all that passes.
class CapturingTransport : public Transport {
public:
    CapturingTransport(std::shared_ptr<Transport> inner, CaptureDestination destination,
                       std::shared_ptr<CaptureMonitor> monitor = nullptr)
        : m_inner(std::move(inner)), m_destination(std::move(destination)), m_monitor(std::move(monitor))
    {
    }
    CapturingTransport(std::shared_ptr<Transport> inner, const QString& file)
        : CapturingTransport(std::move(inner), CaptureDestination{file, {}, {}})
    {
    }

    /// FileUnwritable for a file that cannot be made, or the transport's own errors.
    Expected<void> open() override;
    Expected<protocol::Report> feature(protocol::ReportId id) override;
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override;
    bool write(const protocol::Report& report) override;
    void close() noexcept override;
    void writeOnCrash(const protocol::Report& report) override { m_inner->writeOnCrash(report); }
    [[nodiscard]] Place place() const override { return m_inner->place(); }
    [[nodiscard]] bool streamsAlways() const override { return m_inner->streamsAlways(); }
    [[nodiscard]] bool keepsComputerTime() const override { return m_inner->keepsComputerTime(); }
    [[nodiscard]] bool takesCommands() const override { return m_inner->takesCommands(); }
    void note(const QString& text) override;
    [[nodiscard]] QString keptSession() const override;

private:
    const std::shared_ptr<Transport> m_inner;
    const CaptureDestination m_destination;
    const std::shared_ptr<CaptureMonitor> m_monitor;
    mutable std::mutex m_mutex;              ///< guards opening and finishing of the writer, not its use
    std::unique_ptr<CaptureWriter> m_writer; ///< set by open(), before anything is read or written
    std::atomic<bool> m_reading{false};      ///< a report that is read now is to be kept as well
};

/// A capture played back: at the pace it was taken, faster, or, at speed 0, as fast as its reports are read.
/// Commands are not taken; at the end read() says Ended.
class CaptureReplayTransport : public Transport {
public:
    explicit CaptureReplayTransport(QString file, double speed = 1) : m_file(std::move(file)), m_speed(speed)
    {
    }

    Expected<void> open() override;
    Expected<protocol::Report> feature(protocol::ReportId id) override;
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override;
    bool write(const protocol::Report&) override { return false; }
    void close() noexcept override;
    [[nodiscard]] bool streamsAlways() const override { return false; }
    [[nodiscard]] bool waitsForReader() const override { return m_speed == 0; }
    [[nodiscard]] bool takesCommands() const override { return false; }

private:
    using Clock = std::chrono::steady_clock;
    Expected<void> findNextInput(); ///< features on the way are kept
    [[nodiscard]] Clock::time_point due() const;

    const QString m_file;
    const double m_speed;
    std::optional<CaptureReader> m_reader;    ///< from open() on the reading thread's own, as all here
    std::optional<CaptureRecord> m_nextInput; ///< none at the end
    std::vector<CaptureRecord> m_features;    ///< those before the first input
    std::uint64_t m_firstInput_us = 0;
    std::optional<Clock::time_point> m_started; ///< the first call of read()
    std::mutex m_mutex;                         ///< guards the flag below
    std::condition_variable m_wake;
    bool m_closed = false;
};

} // namespace gripscope
