// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_plan.h"

#include "core/base/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t blocks = 10;
constexpr double criticalT = 5.041; ///< Student's t, two-sided p = 0.001, blocks - 2 degrees of freedom

double meanOf(std::span<const double> values)
{
    double sum = 0;
    for (const double value : values)
        sum += value - values.front();
    return values.front() + sum / static_cast<double>(values.size());
}

struct Line {
    double rise = 0;  ///< over the whole length
    double error = 0; ///< standard error of it
};
Line lineThrough(const std::array<double, blocks>& means)
{
    const double middle = meanOf(means);
    constexpr double center = (blocks - 1) / 2.0;
    double squares = 0;
    double products = 0;
    for (std::size_t i = 0; i < blocks; ++i) {
        const double x = static_cast<double>(i) - center;
        squares += x * x;
        products += x * (means[i] - middle);
    }
    const double slope = products / squares;
    double residual = 0;
    for (std::size_t i = 0; i < blocks; ++i)
        residual += std::pow(means[i] - middle - slope * (static_cast<double>(i) - center), 2);
    return {slope * blocks, blocks * std::sqrt(residual / (blocks - 2) / squares)};
}

} // namespace

std::optional<Error> problemOf(const CalibrationPlan& plan)
{
    const auto usage = [](const Finding& words) { return Error{ErrorCode::Usage, {words}}; };
    if (plan.degree < 1 || plan.degree > highestCalibrationDegree)
        return usage(Words::say("The degree of the curve is %1; it may be 1 to %2.")
                         .arg(plan.degree)
                         .arg(highestCalibrationDegree));
    if (!std::all_of(plan.loads.begin(), plan.loads.end(), [](double load) { return std::isfinite(load); }) ||
        std::adjacent_find(plan.loads.begin(), plan.loads.end(), std::greater_equal<>()) != plan.loads.end())
        return usage(Words::say("The loads must be different numbers, the least first."));
    if (static_cast<int>(plan.loads.size()) < plan.degree + 1)
        return usage(Words::say("A curve of degree %1 needs at least %2 loads; there are %3.")
                         .arg(plan.degree)
                         .arg(plan.degree + 1)
                         .arg(plan.loads.size()));
    constexpr int mostRuns = 20;
    if (plan.runs < 1 || plan.runs > mostRuns)
        return usage(Words::say("There are %1 runs; there may be 1 to %2.").arg(plan.runs).arg(mostRuns));
    const std::vector<PlannedPoint> planned = plannedPoints(plan);
    if (std::ranges::count(planned, false, &PlannedPoint::check) < plan.degree + 2)
        return usage(Words::say("A curve of degree %1 needs at least %2 points: go down again, or add a run.")
                         .arg(plan.degree)
                         .arg(plan.degree + 2));
    if (std::optional<Error> problem = problemOf(plan.conditions))
        return problem;
    constexpr double longest_s = 60;
    if (!(plan.averaging_s > 0) || plan.averaging_s > longest_s)
        return usage(Words::say("A reading is averaged over %1 s; more than 0 and at most %2 s make sense.")
                         .arg(plan.averaging_s)
                         .arg(longest_s));
    return std::nullopt;
}

std::vector<PlannedPoint> plannedPoints(const CalibrationPlan& plan)
{
    std::vector<PlannedPoint> points;
    const int runs = plan.runs + (plan.checkAfter ? 1 : 0);
    for (int run = 1; run <= runs; ++run) {
        const bool check = run > plan.runs;
        for (std::size_t i = 0; i < plan.loads.size(); ++i)
            if (points.empty() || i > 0 || points.back().load != plan.loads[i])
                points.push_back({plan.loads[i], run, true, check});
        for (std::size_t i = plan.loads.size(); plan.descending && i-- > 1;)
            points.push_back({plan.loads[i - 1], run, false, check});
    }
    return points;
}

SteadyReading steadyReading(std::span<const double> values, const SteadyOptions& options)
{
    SteadyReading reading;
    reading.samples = values.size();
    if (values.size() < std::max(options.leastSamples, 2 * blocks))
        return reading;
    reading.mean = meanOf(values);
    double squares = 0;
    for (const double value : values)
        squares += (value - reading.mean) * (value - reading.mean);
    reading.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
    std::array<double, blocks> means{};
    const std::size_t length = values.size() / blocks;
    for (std::size_t i = 0; i < blocks; ++i)
        means[i] = meanOf(values.subspan(i * length, length));
    const Line line = lineThrough(means);
    reading.drift = line.rise;
    const bool matters = std::abs(line.rise) > options.driftAllowed;
    reading.status =
        matters && std::abs(line.rise) > criticalT * line.error ? SteadyStatus::Moving : SteadyStatus::Steady;
    return reading;
}

} // namespace gripscope
