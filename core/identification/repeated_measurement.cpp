// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/repeated_measurement.h"

#include "core/identification/pooled_mean.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

Eigen::Vector3d standardErrors(const UncertaintyBudget& budget, EvaluationType type)
{
    Eigen::Vector3d variances = Eigen::Vector3d::Zero();
    for (const BudgetLine& line : budget.lines)
        if (line.type == type)
            variances += line.covariance.diagonal();
    return variances.cwiseMax(0).cwiseSqrt();
}

bool isUsable(const UncertaintyBudget& budget)
{
    return budget.parameters && budget.parameters->vector().allFinite() &&
           budget.parameters->vector().minCoeff() > 0 && budget.covariance.allFinite();
}

/// A floor keeps a squeeze without noise from outweighing all others without end.
double withFloor(double error, double value)
{
    constexpr double leastRelativeError = 1e-9;
    return std::max(error, leastRelativeError * value);
}

} // namespace

double RepeatedMeasurement::standardUncertainty(std::size_t parameter) const
{
    return std::hypot(ownErrors[parameter], sharedErrors[parameter]);
}

std::optional<RepeatedMeasurement> repeatedMeasurement(std::span<const Identification> squeezes)
{
    const auto usable = [](const Identification& squeeze) { return isUsable(squeeze.budget); };
    if (squeezes.empty() || !std::all_of(squeezes.begin(), squeezes.end(), usable))
        return std::nullopt;
    RepeatedMeasurement found;
    const std::array<double*, 3> values{&found.parameters.m, &found.parameters.b, &found.parameters.k};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto index = static_cast<Eigen::Index>(i);
        std::vector<ValueWithError> measured;
        for (const Identification& squeeze : squeezes) {
            const double value = squeeze.budget.parameters->vector()(index);
            const double own = standardErrors(squeeze.budget, EvaluationType::A)(index);
            const double shared = standardErrors(squeeze.budget, EvaluationType::B)(index);
            measured.push_back({value, withFloor(own, value)});
            found.sharedErrors[i] = std::max(found.sharedErrors[i], shared);
        }
        const ValueWithError mean = pooledMean(measured);
        *values[i] = mean.value;
        found.ownErrors[i] = mean.standardError;
    }
    return found;
}

} // namespace gripscope
