// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/study_tally.h"

#include "core/parallel_runs.h"

#include <algorithm>
#include <cmath>

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
    shareAmongThreads(std::int64_t(tallies.size()), threads,
                      [&](std::int64_t run) { tallies[std::size_t(run)] = one(int(run)); });
    return tallies;
}

} // namespace gripscope
