// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace gripscope {

/// Items `begin` up to `end` (exclusive), the chunk of that number.
struct Chunk {
    std::size_t number = 0, begin = 0, end = 0;
};

/// Long tables are worked through in chunks of this many items. What is summed up a chunk and then over the
/// chunks in order does not depend on how many processors there are.
inline constexpr std::size_t itemsInChunk = 8192;

[[nodiscard]] constexpr std::size_t chunkCount(std::size_t items)
{
    return (items + itemsInChunk - 1) / itemsInChunk;
}

/// `work` on every chunk of `items` items, on all processors at once where there is more than one chunk; back
/// when all are done. It must not throw, and chunks may not write to the same place.
void forEachChunk(std::size_t items, const std::function<void(const Chunk&)>& work);

} // namespace gripscope
