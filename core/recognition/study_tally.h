// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QString>

#include <cstdint>
#include <functional>
#include <vector>

namespace gripscope {

/// What was counted in one enrolment: so many cases, and how many of them were each thing by name.
struct EnrolmentTally {
    double cases = 0;
    QMap<QString, double> counts;
};

/// A share of all cases, with its standard error when the enrolments, not the cases, are independent:
///     s^2 = sum_e (count_e - share cases_e)^2 / (sum_e cases_e)^2   (Cochran, Sampling Techniques, 3rd ed.,
/// section 9A). A share of squeezes that share an enrolment is known less well than a binomial says.
struct ClusteredShare {
    double share = 0, standardError = 0;
    double count = 0;
};

struct StudyTally {
    int enrolments = 0;
    double cases = 0;
    QMap<QString, ClusteredShare> shares; ///< every name that any enrolment counted
};
[[nodiscard]] StudyTally pooled(const std::vector<EnrolmentTally>& enrolments);

/// `one(run)` for run = 0..runs-1, on so many threads (0: as many as the machine has). The results are in
/// the order of the runs, whatever the threads. `one` must not share anything that changes.
[[nodiscard]] std::vector<EnrolmentTally> tallyRuns(int runs, int threads,
                                                    const std::function<EnrolmentTally(int)>& one);

} // namespace gripscope
