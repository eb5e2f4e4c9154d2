// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/parameter_text.h"

#include "core/math/normal_interval.h"
#include "core/signal/recording/units.h"

#include <cmath>

namespace gripscope {

ParameterTexts parameterTextsWithin(const MassDampingStiffness& parameters,
                                    const std::optional<Eigen::Vector3d>& halfWidths,
                                    const QString& forceUnit, const QString& positionUnit)
{
    const std::optional<double> si = siFactor(forceUnit, positionUnit);
    const double factor = si.value_or(1.0);
    const ParameterUnits units = comparableUnits(forceUnit, positionUnit);
    const auto one = [&](double value, int i, const QString& unit) {
        std::optional<double> error;
        if (halfWidths)
            error = factor * (*halfWidths)[i];
        return formatNumber(value * factor, error, unit);
    };
    return {one(parameters.m, 0, units.m), one(parameters.b, 1, units.b), one(parameters.k, 2, units.k)};
}

ParameterTexts parameterTexts(const MassDampingStiffness& parameters,
                              const std::optional<Eigen::Vector3d>& standardErrors, const QString& forceUnit,
                              const QString& positionUnit)
{
    std::optional<Eigen::Vector3d> halfWidths;
    if (standardErrors)
        halfWidths = normal95 * *standardErrors;
    return parameterTextsWithin(parameters, halfWidths, forceUnit, positionUnit);
}

ParameterTexts parameterTexts(const Estimate& estimate, const QString& forceUnit, const QString& positionUnit)
{
    if (!estimate.parameters)
        return {formatNumber(NAN, std::nullopt, {}), formatNumber(NAN, std::nullopt, {}),
                formatNumber(NAN, std::nullopt, {})};
    return parameterTexts(*estimate.parameters, estimate.standardErrors(), forceUnit, positionUnit);
}

ParameterTexts parameterTexts(const Identification& identification, const QString& forceUnit,
                              const QString& positionUnit)
{
    const UncertaintyBudget& budget = identification.budget;
    if (!budget.parameters) {
        const Estimate* const best = identification.best();
        return parameterTexts(best != nullptr ? *best : Estimate(), forceUnit, positionUnit);
    }
    Eigen::Vector3d halfWidths;
    for (std::size_t i = 0; i < budget.combined.size(); ++i)
        halfWidths(static_cast<Eigen::Index>(i)) =
            budget.combined[i].coverageFactor * budget.combined[i].standardUncertainty;
    return parameterTextsWithin(*budget.parameters, halfWidths, forceUnit, positionUnit);
}

} // namespace gripscope
