// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/capture_writer.h"
#include "devices/transport.h"

#include <condition_variable>
#include <mutex>

namespace gripscope {

/// Any transport, with a capture of all that passes.
class CapturingTransport : public Transport {
public:
    CapturingTransport(std::shared_ptr<Transport> inner, QString file)
        : m_inner(std::move(inner)), m_file(std::move(file))
    {
    }

    Expected<void> open() override;
    Expected<protocol::Report> feature(protocol::ReportId id) override;
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override;
    bool write(const protocol::Report& report) override;
    void close() noexcept override;
    [[nodiscard]] Place place() const override { return m_inner->place(); }
    [[nodiscard]] bool streamsAlways() const override { return m_inner->streamsAlways(); }
    [[nodiscard]] bool takesCommands() const override { return m_inner->takesCommands(); }

private:
    const std::shared_ptr<Transport> m_inner;
    const QString m_file;
    std::mutex m_mutex;                      ///< guards opening and finishing of the writer, not its use
    std::unique_ptr<CaptureWriter> m_writer; ///< set by open(), before anything is read or written
};

/// A capture played back at the pace it was taken. Commands are not taken; at the end read() says Ended.
class CaptureReplayTransport : public Transport {
public:
    explicit CaptureReplayTransport(QString file) : m_file(std::move(file)) {}

    Expected<void> open() override;
    Expected<protocol::Report> feature(protocol::ReportId id) override;
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override;
    bool write(const protocol::Report&) override { return false; }
    void close() noexcept override;
    [[nodiscard]] bool streamsAlways() const override { return false; }
    [[nodiscard]] bool takesCommands() const override { return false; }

private:
    using Clock = std::chrono::steady_clock;
    const QString m_file;
    std::vector<CaptureRecord> m_records; ///< set by open()
    std::size_t m_next = 0;               ///< reader's own
    std::uint64_t m_firstInput_us = 0;
    std::optional<Clock::time_point> m_started; ///< reader's own: its first call
    std::mutex m_mutex;                         ///< guards the flag below
    std::condition_variable m_wake;
    bool m_closed = false;
};

} // namespace gripscope
