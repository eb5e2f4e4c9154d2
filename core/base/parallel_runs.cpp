// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_runs.h"

#include "core/base/vector_registers.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace gripscope {

namespace {

/// The finalizer of splitmix64 (Steele, Lea, Flood 2014): neighbouring numbers become unrelated seeds.
[[nodiscard]] constexpr std::uint64_t mixedSeed(std::uint64_t value)
{
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27U)) * 0x94d049bb133111ebu;
    return value ^ (value >> 31U);
}

} // namespace

std::uint64_t runSeed(std::uint64_t seed, const QString& name, std::uint64_t run)
{
    std::uint64_t mix = mixedSeed(seed);
    for (const QChar letter : name)
        mix = mixedSeed(mix ^ letter.unicode());
    return mixedSeed(mix ^ run);
}

void shareAmongThreads(std::int64_t count, int threads, const std::function<void(std::int64_t)>& work)
{
    std::atomic<std::int64_t> next = 0;
    const auto takeAll = [&] {
        releaseVectorRegisters();
        for (std::int64_t number = next++; number < count; number = next++)
            work(number);
    };
    const std::int64_t wanted =
        threads > 0 ? threads : std::max<std::int64_t>(1, std::thread::hardware_concurrency());
    std::vector<std::thread> helpers;
    for (std::int64_t i = 1; i < std::min(count, wanted); ++i)
        helpers.emplace_back(takeAll);
    takeAll();
    for (std::thread& helper : helpers)
        helper.join();
}

void performRuns(std::int64_t runs, int threads,
                 const std::function<void(std::int64_t, std::int64_t)>& progress,
                 const std::function<void(std::int64_t)>& perform)
{
    std::mutex reporting; // guards `done` and the callback
    std::int64_t done = 0;
    shareAmongThreads(runs, threads, [&](std::int64_t run) {
        perform(run);
        const std::lock_guard guard(reporting);
        ++done;
        if (progress)
            progress(done, runs);
    });
}

void forEachChunk(std::size_t items, const std::function<void(const Chunk&)>& work)
{
    shareAmongThreads(static_cast<std::int64_t>(chunkCount(items)), 0, [&](std::int64_t chunk) {
        const auto number = static_cast<std::size_t>(chunk);
        work({number, number * itemsInChunk, std::min(items, (number + 1) * itemsInChunk)});
    });
}

} // namespace gripscope
