// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/study_tally.h"

#include "core/signal/mixed_seed.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace gripscope {

StudyTally pooled(const std::vector<EnrolmentTally>& enrolments)
{
    StudyTally tally;
    tally.enrolments = int(enrolments.size());
    for (const EnrolmentTally& one : enrolments) {
        tally.cases += one.cases;
        for (auto it = one.counts.cbegin(); it != one.counts.cend(); ++it)
            tally.shares[it.key()].count += it.value();
    }
    if (!(tally.cases > 0))
        return tally;
    for (auto it = tally.shares.begin(); it != tally.shares.end(); ++it) {
        it->share = it->count / tally.cases;
        double squares = 0;
        for (const EnrolmentTally& one : enrolments)
            squares += std::pow(one.counts.value(it.key(), 0) - it->share * one.cases, 2);
        it->standardError = std::sqrt(squares) / tally.cases;
    }
    return tally;
}

std::vector<EnrolmentTally> tallyRuns(int runs, int threads, const std::function<EnrolmentTally(int)>& one)
{
    std::vector<EnrolmentTally> tallies(std::size_t(std::max(0, runs)));
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int run = next++; run < runs; run = next++)
            tallies[std::size_t(run)] = one(run);
    };
    const unsigned wanted =
        threads > 0 ? unsigned(threads) : std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::thread> helpers;
    for (unsigned i = 1; i < wanted && int(i) < runs; ++i)
        helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers)
        helper.join();
    return tallies;
}

std::uint64_t studySeed(std::uint64_t seed, const QString& row, int run)
{
    std::uint64_t mix = mixedSeed(seed);
    for (const QChar letter : row)
        mix = mixedSeed(mix ^ letter.unicode());
    return mixedSeed(mix ^ static_cast<std::uint64_t>(run));
}

} // namespace gripscope
