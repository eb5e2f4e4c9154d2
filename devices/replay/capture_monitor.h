// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

#include <atomic>
#include <mutex>
#include <optional>

namespace gripscope {

struct CaptureStatus {
    QString session;                  ///< name of the kept session; empty for a file of its own
    std::uint64_t records = 0;        ///< in files
    std::uint64_t droppedRecords = 0; ///< found no room, because the disk is slow, or could not be written
    std::optional<Error> problem;     ///< the last one; none while all is well
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
    std::atomic<std::uint64_t> m_dropped{0};
};

} // namespace gripscope
