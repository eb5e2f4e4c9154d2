// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "devices/replay/capture.h"
#include "devices/transport/bounded_thread.h"

#include <QStringList>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

struct CaptureStatus {
    QString session;                  ///< name of the kept session; empty for a file of its own
    std::uint64_t records = 0;        ///< in files
    std::uint64_t droppedRecords = 0; ///< found no room, because the disk is slow, or could not be written
    std::optional<Error> problem;     ///< the last one; none while all is well
};

/// Older parts that made room for newer ones, at once.
struct CapturePruning {
    QString folder;
    QStringList parts; ///< names of the files that went
    qint64 bytes = 0, squeezes = 0;
};

/// How the capture under way fares, from the threads that know to the one that shows it.
class CaptureMonitor {
public:
    void begin(const QString& session)
    {
        m_dropped = 0;
        const std::lock_guard lock(m_mutex);
        m_status = {};
        m_status.session = session;
    }
    /// By the writing thread.
    void written(std::uint64_t records, const std::optional<Error>& problem)
    {
        const std::lock_guard lock(m_mutex);
        m_status.records = records;
        m_status.problem = problem;
    }
    /// By the writing thread.
    void pruned(const CapturePruning& pruning)
    {
        const std::lock_guard lock(m_mutex);
        m_prunings.push_back(pruning);
    }
    /// Those that nobody took yet.
    [[nodiscard]] std::vector<CapturePruning> takePrunings()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_prunings, {});
    }
    /// From any thread; never waits.
    void dropped(std::uint64_t records) { m_dropped += records; }

    [[nodiscard]] CaptureStatus status() const
    {
        const std::lock_guard lock(m_mutex);
        CaptureStatus status = m_status;
        status.droppedRecords = m_dropped;
        return status;
    }

private:
    mutable std::mutex m_mutex;
    CaptureStatus m_status;
    std::vector<CapturePruning> m_prunings;
    std::atomic<std::uint64_t> m_dropped{0};
};

/// Records on their way from the threads that talk to a gripper to the one that writes to the disk. Of fixed
/// size: who adds only copies a record, and one that finds no room is dropped and counted.
class CaptureBuffer {
public:
    /// What was added between two calls of take().
    struct Chunk {
        std::vector<std::uint8_t> bytes;
        std::uint64_t records = 0;
        std::uint64_t squeezes = 0;       ///< notes of squeezes that ended
        std::uint64_t droppedRecords = 0; ///< behind those in `bytes`
    };

    CaptureBuffer(std::size_t capacity, std::shared_ptr<CaptureMonitor> monitor);

    /// From any thread; the record's time is now. Nothing once finish() was called.
    void add(CaptureKind kind, std::span<const std::uint8_t> bytes);
    /// Nothing more is added, and take() does not wait any more.
    void finish();

    /// The writing thread: swaps `chunk`, which is forgotten, for what is there after `atMost`, or after
    /// finish(). False: nothing is there, and nothing will come.
    bool take(Chunk& chunk, std::chrono::milliseconds atMost);
    /// The feature reports added so far, as records of `time_us`: every part of a session begins with them.
    [[nodiscard]] QByteArray features(std::uint64_t time_us) const;

private:
    const std::size_t m_capacity;
    const std::shared_ptr<CaptureMonitor> m_monitor;
    const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    mutable std::mutex m_mutex; ///< guards all below; held for a copy or a swap
    std::condition_variable m_wake;
    Chunk m_filling;
    std::vector<std::vector<std::uint8_t>> m_features;
    bool m_finished = false;
};

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
