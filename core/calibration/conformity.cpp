// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/conformity.h"

#include "core/calibration/sensor_correction.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gripscope {

namespace {

/// Without a correction the reading is what the gripper says.
LoadErrors errorsOf(const std::vector<CalibrationPoint>& points, const SensorCorrection* correction)
{
    LoadErrors errors;
    errors.each.reserve(points.size());
    for (const CalibrationPoint& point : points) {
        const double said = correction ? correction->loadOf(point.reading) : point.reading;
        errors.each.push_back(said - point.load);
        errors.largest = std::max(errors.largest, std::abs(errors.each.back()));
    }
    return errors;
}

struct Sum {
    double of = 0;
    int count = 0;
    [[nodiscard]] std::optional<double> mean() const
    {
        return count > 0 ? std::optional(of / count) : std::nullopt;
    }
};

} // namespace

std::optional<LoadErrors> errorsAsFound(const SensorCalibration& calibration)
{
    if (!calibration.foundCorrection)
        return std::nullopt;
    if (calibration.foundCorrection->isEmpty())
        return errorsOf(calibration.points, nullptr);
    const std::optional<SensorCorrection> before = SensorCorrection::fromText(*calibration.foundCorrection);
    return before ? std::optional(errorsOf(calibration.points, &*before)) : std::nullopt;
}

LoadErrors errorsAsLeft(const SensorCalibration& calibration, const CalibrationEvaluation& evaluation)
{
    const SensorCorrection correction(evaluation.curve);
    return errorsOf(calibration.checkPoints.empty() ? calibration.points : calibration.checkPoints,
                    &correction);
}

CalibrationConformity judgeConformity(double largestError, double expandedUncertainty, double tolerance,
                                      DecisionRule rule)
{
    const double guard = rule == DecisionRule::Guarded ? expandedUncertainty : 0;
    if (largestError + guard <= tolerance)
        return CalibrationConformity::Conforms;
    return largestError - guard > tolerance ? CalibrationConformity::DoesNotConform
                                            : CalibrationConformity::Undecided;
}

std::vector<UpAndDown> upAndDown(const std::vector<CalibrationPoint>& points)
{
    const std::vector<bool> ascending = ascendingPoints(points);
    std::map<double, std::pair<Sum, Sum>> loads;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto& [up, down] = loads[points[i].load];
        Sum& sum = ascending[i] ? up : down;
        sum.of += points[i].reading;
        ++sum.count;
    }
    std::vector<UpAndDown> rows;
    rows.reserve(loads.size());
    for (const auto& [load, sums] : loads)
        rows.push_back({load, sums.first.mean(), sums.second.mean()});
    return rows;
}

} // namespace gripscope
