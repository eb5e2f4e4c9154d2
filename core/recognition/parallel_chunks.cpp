// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/parallel_chunks.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace gripscope {

void forEachChunk(std::size_t items, const std::function<void(const Chunk&)>& work)
{
    const std::size_t chunks = chunkCount(items);
    std::atomic<std::size_t> next = 0;
    const auto takeAll = [&] {
        for (std::size_t number = next++; number < chunks; number = next++)
            work({number, number * itemsInChunk, std::min(items, (number + 1) * itemsInChunk)});
    };
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < std::min(chunks, processors); ++i)
        helpers.emplace_back(takeAll);
    takeAll();
    for (std::thread& helper : helpers)
        helper.join();
}

} // namespace gripscope
