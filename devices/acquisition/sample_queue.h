// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <vector>

namespace gripscope {

/// Samples on their way from one thread that acquires to one thread that uses them; bounded, without locks.
/// Nobody waits: what does not fit is not taken, and push() says how much.
class SampleQueue {
public:
    /// 32 s at 2 kHz, and more than the longest squeeze of the virtual gripper.
    static constexpr std::size_t defaultCapacity = 65536;

    explicit SampleQueue(std::size_t capacity = defaultCapacity) : m_ring(capacity) {}

    /// Acquiring thread only. How many were taken; the rest, the newest, is dropped.
    std::size_t push(std::span<const Sample> samples)
    {
        const std::uint64_t head = m_head.load(std::memory_order_relaxed);
        const std::uint64_t used = head - m_tail.load(std::memory_order_acquire);
        const std::size_t count = std::min<std::size_t>(samples.size(), m_ring.size() - used);
        for (std::size_t i = 0; i < count; ++i)
            m_ring[(head + i) % m_ring.size()] = samples[i];
        m_head.store(head + count, std::memory_order_release);
        return count;
    }

    /// Using thread only. Appends at most `most` samples; how many.
    std::size_t pop(std::vector<Sample>& samples, std::size_t most)
    {
        const std::uint64_t tail = m_tail.load(std::memory_order_relaxed);
        const std::uint64_t there = m_head.load(std::memory_order_acquire) - tail;
        const std::size_t count = std::min<std::size_t>(most, there);
        for (std::size_t i = 0; i < count; ++i)
            samples.push_back(m_ring[(tail + i) % m_ring.size()]);
        m_tail.store(tail + count, std::memory_order_release);
        return count;
    }

    /// So many samples fit in now.
    [[nodiscard]] std::size_t room() const { return m_ring.size() - (pushed() - popped()); }

    /// Taken and handed out since the beginning.
    [[nodiscard]] std::uint64_t pushed() const { return m_head.load(std::memory_order_acquire); }
    [[nodiscard]] std::uint64_t popped() const { return m_tail.load(std::memory_order_acquire); }

private:
    std::vector<Sample> m_ring;
    std::atomic<std::uint64_t> m_head{0};
    std::atomic<std::uint64_t> m_tail{0};
};

} // namespace gripscope
