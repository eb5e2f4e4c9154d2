// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/capture.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace gripscope {

/// Writes a capture behind the back of the threads that read and write reports: they only append to a buffer,
/// a thread of its own brings it to the disk.
class CaptureWriter {
public:
    /// FileUnwritable.
    [[nodiscard]] static Expected<std::unique_ptr<CaptureWriter>> create(const QString& file);
    ~CaptureWriter();
    CaptureWriter(const CaptureWriter&) = delete;
    CaptureWriter& operator=(const CaptureWriter&) = delete;

    void add(CaptureKind kind, std::span<const std::uint8_t> bytes);
    /// Everything added so far is in the file then; what is added later is not. By one thread at a time.
    void finish();

private:
    explicit CaptureWriter(const QString& file);
    void run();

    const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    const QString m_file;
    std::mutex m_mutex; ///< guards the two below
    QByteArray m_waiting = captureHeader();
    bool m_ending = false;
    std::condition_variable m_wake;
    std::thread m_thread;
};

} // namespace gripscope
