// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/capture_buffer.h"
#include "devices/transport/bounded_thread.h"

namespace gripscope {

/// How much is kept.
struct CaptureLimits {
    qint64 totalBytes =
        2'000'000'000; ///< of all kept sessions together: seven hours at 1,000 reports a second
    qint64 partBytes = qint64(64) * 1024 * 1024;
    std::chrono::seconds partTime{15 * 60};
    /// On the way to the disk: a minute at 1,000 reports a second.
    std::size_t bufferBytes = std::size_t(4) * 1024 * 1024;
};

/// Where a session is written to: one file, which is replaced, or parts in a folder of kept sessions.
struct CaptureDestination {
    QString file;
    QString folder;
    QString address; ///< of the gripper, for the reader
    CaptureLimits limits = {};
};

/// Writes a capture behind the back of the threads that read and write reports: they only copy into a buffer
/// of fixed size, a thread of its own brings it to the disk. A disk that is full, slow or gone costs records
/// of the capture, which are counted, and nothing else; it is tried again each second.
class CaptureWriter {
public:
    /// FileUnwritable for a file that cannot be made. A folder that cannot be used is a problem of the
    /// status, and the session goes on without being kept.
    [[nodiscard]] static Expected<std::unique_ptr<CaptureWriter>>
    create(const CaptureDestination& destination, std::shared_ptr<CaptureMonitor> monitor = nullptr);
    ~CaptureWriter();
    CaptureWriter(const CaptureWriter&) = delete;
    CaptureWriter& operator=(const CaptureWriter&) = delete;

    void add(CaptureKind kind, std::span<const std::uint8_t> bytes);
    [[nodiscard]] QString session() const { return m_session; }
    /// Everything added so far is in the file then, and the file is closed; what is added later is not.
    /// False: the disk takes longer; the rest is written behind this object's back. By one thread at a time.
    bool finishBy(std::chrono::steady_clock::time_point deadline);

private:
    CaptureWriter(std::shared_ptr<CaptureBuffer> buffer, QString session, BoundedThread thread);

    const std::shared_ptr<CaptureBuffer> m_buffer;
    const QString m_session;
    BoundedThread m_thread;
};

} // namespace gripscope
