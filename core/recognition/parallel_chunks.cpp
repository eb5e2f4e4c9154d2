// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/parallel_chunks.h"

#include "core/parallel_runs.h"

#include <algorithm>

namespace gripscope {

void forEachChunk(std::size_t items, const std::function<void(const Chunk&)>& work)
{
    shareAmongThreads(static_cast<std::int64_t>(chunkCount(items)), 0, [&](std::int64_t chunk) {
        const auto number = static_cast<std::size_t>(chunk);
        work({number, number * itemsInChunk, std::min(items, (number + 1) * itemsInChunk)});
    });
}

} // namespace gripscope
