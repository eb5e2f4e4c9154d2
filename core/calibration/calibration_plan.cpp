// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_plan.h"

#include "core/words.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace gripscope {

using namespace Qt::StringLiterals;

std::optional<Error> problemOf(const CalibrationPlan& plan)
{
    const auto usage = [](const QString& words) { return Error{ErrorCode::Usage, {words}}; };
    if (plan.degree < 1 || plan.degree > highestCalibrationDegree)
        return usage(Words::tr("The degree of the curve is %1; it may be 1 to %2.")
                         .arg(plan.degree)
                         .arg(highestCalibrationDegree));
    if (!std::all_of(plan.loads.begin(), plan.loads.end(), [](double load) { return std::isfinite(load); }) ||
        std::adjacent_find(plan.loads.begin(), plan.loads.end(), std::greater_equal<>()) != plan.loads.end())
        return usage(Words::tr("The loads must be different numbers, the least first."));
    if (static_cast<int>(plan.loads.size()) < plan.degree + 1)
        return usage(Words::tr("A curve of degree %1 needs at least %2 loads; there are %3.")
                         .arg(plan.degree)
                         .arg(plan.degree + 1)
                         .arg(plan.loads.size()));
    constexpr int mostRuns = 20;
    if (plan.runs < 1 || plan.runs > mostRuns)
        return usage(Words::tr("There are %1 runs; there may be 1 to %2.").arg(plan.runs).arg(mostRuns));
    if (static_cast<int>(plannedPoints(plan).size()) < plan.degree + 2)
        return usage(Words::tr("A curve of degree %1 needs at least %2 points: go down again, or add a run.")
                         .arg(plan.degree)
                         .arg(plan.degree + 2));
    constexpr double longest_s = 60;
    if (!(plan.averaging_s > 0) || plan.averaging_s > longest_s)
        return usage(Words::tr("A reading is averaged over %1 s; more than 0 and at most %2 s make sense.")
                         .arg(plan.averaging_s)
                         .arg(longest_s));
    return std::nullopt;
}

std::vector<PlannedPoint> plannedPoints(const CalibrationPlan& plan)
{
    std::vector<PlannedPoint> points;
    for (int run = 1; run <= plan.runs; ++run) {
        for (std::size_t i = 0; i < plan.loads.size(); ++i)
            if (points.empty() || i > 0 || points.back().load != plan.loads[i])
                points.push_back({plan.loads[i], run, true});
        for (std::size_t i = plan.loads.size(); plan.descending && i-- > 1;)
            points.push_back({plan.loads[i - 1], run, false});
    }
    return points;
}

} // namespace gripscope
