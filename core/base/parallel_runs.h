// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace gripscope {

/// Calls `work(0)` to `work(count - 1)`, shared out among threads (0: as many as the machine has); back when
/// all are done. Calls must not throw, nor write to the same place: then the number of threads changes
/// nothing.
void shareAmongThreads(std::int64_t count, int threads, const std::function<void(std::int64_t)>& work);

/// The same for the runs of a study, each of which draws its random numbers from a seed of its own.
/// `progress` (may be empty) is told the runs done and those to do, from one thread at a time.
void performRuns(std::int64_t runs, int threads,
                 const std::function<void(std::int64_t, std::int64_t)>& progress,
                 const std::function<void(std::int64_t)>& perform);

/// The seed of one run of a study's row of this name: nothing to do with its neighbours', nor with the other
/// rows.
[[nodiscard]] std::uint64_t runSeed(std::uint64_t seed, const QString& name, std::uint64_t run);

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
