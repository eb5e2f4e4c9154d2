// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/capture.h"
#include "devices/replay/capture_monitor.h"

#include <chrono>
#include <condition_variable>
#include <memory>

namespace gripscope {

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

} // namespace gripscope
