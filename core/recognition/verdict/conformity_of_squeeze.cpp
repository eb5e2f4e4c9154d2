// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/conformity_of_squeeze.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr std::array limitedParameters{MotionParameter::Mass, MotionParameter::Damping,
                                       MotionParameter::Stiffness};

MeasuredValue measuredOf(double value, const CombinedUncertainty& combined)
{
    MeasuredValue measured{value, {}, combined.degreesOfFreedom};
    if (combined.standardUncertainty > 0)
        measured.standardUncertainty = combined.standardUncertainty;
    return measured;
}

MeasuredValues byBudget(const UncertaintyBudget& budget)
{
    MeasuredValues measured;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        if (budget.parameters && !budget.intervals[i].onlyUpperBound)
            measured[i] =
                measuredOf(budget.parameters->vector()[static_cast<Eigen::Index>(i)], budget.combined[i]);
        const auto further =
            std::ranges::find(budget.further, limitedParameters[i], &FurtherParameter::parameter);
        if (!budget.parameters && further != budget.further.end() && !further->interval.onlyUpperBound)
            measured[i] = measuredOf(further->value, further->combined);
    }
    return measured;
}

/// Gives `value` the uncertainty of the squeeze's own and that of the adjustment together.
void combine(MeasuredValue& value, double own, double added, double addedDegrees)
{
    const double variance = own * own + added * added;
    value.standardUncertainty = std::sqrt(variance);
    double spread = 0; // sum of u_i^4 / v_i
    if (value.degreesOfFreedom && *value.degreesOfFreedom > 0)
        spread += std::pow(own, 4) / *value.degreesOfFreedom;
    if (addedDegrees > 0)
        spread += std::pow(added, 4) / addedDegrees;
    value.degreesOfFreedom = spread > 0 ? std::optional(variance * variance / spread) : std::nullopt;
}

} // namespace

MeasuredValues measuredValues(const Identification& identification, double factor)
{
    MeasuredValues measured = byBudget(identification.budget);
    const std::optional<CorrectedParameters> object = identification.object();
    const bool isBudgeted =
        identification.budget.parameters.has_value() || !identification.budget.further.empty();
    for (std::size_t i = 0; object && !isBudgeted && i < measured.size(); ++i)
        measured[i] = MeasuredValue{object->parameters.vector()[static_cast<Eigen::Index>(i)]};
    for (std::optional<MeasuredValue>& one : measured) {
        if (!one)
            continue;
        one->value *= factor;
        if (one->standardUncertainty)
            *one->standardUncertainty *= factor;
    }
    return measured;
}

MeasuredValues adjusted(const MeasuredValues& measured, const CommonShift& error)
{
    MeasuredValues moved;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const std::optional<int> place = error.space.placeOf(allQuantities[i]);
        if (!measured[i] || !place)
            continue;
        const double factor = std::exp(-error.value(*place));
        MeasuredValue value{factor * measured[i]->value, {}, measured[i]->degreesOfFreedom};
        if (measured[i]->standardUncertainty)
            combine(value, factor * *measured[i]->standardUncertainty,
                    std::abs(value.value) * std::sqrt(error.covariance(*place, *place)),
                    error.degreesOfFreedom);
        if (std::isfinite(value.value))
            moved[i] = value;
    }
    return moved;
}

std::optional<Conformity> conformityOf(const PartLimits& limits, const Identification& identification,
                                       double toTypeUnits, const std::optional<double>& siFactor,
                                       const std::optional<CommonShift>& transfer)
{
    if (limits.isEmpty())
        return {};
    const MeasuredValues measured = measuredValues(identification, toTypeUnits);
    Expected<Conformity> conformity =
        judgeConformity(limits, transfer ? adjusted(measured, *transfer) : measured, siFactor);
    return conformity ? std::optional(*std::move(conformity)) : std::nullopt;
}

} // namespace gripscope
