// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/conformity/limit_risks.h"

#include <cmath>

namespace gripscope {

namespace {

constexpr double guardRiskOfIso = 0.05;

/// The values with a known uncertainty.
struct KnownValues {
    std::vector<double> values, uncertainties;
};

KnownValues knownValues(const std::vector<MeasuredValues>& squeezes, std::size_t place)
{
    KnownValues known;
    for (const MeasuredValues& squeeze : squeezes) {
        const std::optional<MeasuredValue>& one = squeeze[place];
        if (!one || !one->standardUncertainty || !std::isfinite(one->value) ||
            !std::isfinite(*one->standardUncertainty) || !(*one->standardUncertainty > 0))
            continue;
        known.values.push_back(one->value);
        known.uncertainties.push_back(*one->standardUncertainty);
    }
    return known;
}

double meanOf(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

/// Two passes, for values that differ in their last digits alone.
double varianceAbout(const std::vector<double>& values, double mean)
{
    double sum = 0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return sum / static_cast<double>(values.size() - 1);
}

double guardAt(const PartLimits& limits, double uncertainty)
{
    switch (limits.rule) {
    case ConformityRule::Iso14253:
        return guardForSpecificRisk(uncertainty, guardRiskOfIso);
    case ConformityRule::ConsumersRisk:
        return guardForSpecificRisk(uncertainty, limits.risk);
    case ConformityRule::Simple:
        break;
    }
    return 0;
}

Expected<std::optional<QuantityRisks>> quantityRisks(const PartLimits& limits, const ToleranceLimits& own,
                                                     const KnownValues& known)
{
    QuantityRisks found;
    found.squeezes = static_cast<int>(known.values.size());
    if (found.squeezes < fewestForRisks)
        return std::optional<QuantityRisks>();
    found.mean = meanOf(known.values);
    double squares = 0;
    for (const double u : known.uncertainties)
        squares += u * u;
    squares /= found.squeezes;
    found.uncertainty = std::sqrt(squares);
    const double variance = varianceAbout(known.values, found.mean);
    found.deviationIsOfSqueezes = !(variance > squares);
    found.deviation = std::sqrt(found.deviationIsOfSqueezes ? variance : variance - squares);
    if (!(found.deviation > 0))
        return std::optional<QuantityRisks>();
    found.guard = guardAt(limits, found.uncertainty);
    const MeasuredProcess process{own, found.mean, found.deviation, found.uncertainty};
    ASSIGN_OR_RETURN(found.risks, globalRisks(process, found.guard));
    ASSIGN_OR_RETURN(found.guardForSmallRisk, guardForRisk(process, smallConsumersRisk));
    return std::optional(found);
}

} // namespace

Expected<LimitRisks> limitRisks(const PartLimits& limits, const std::vector<MeasuredValues>& squeezes)
{
    if (std::optional<Error> problem = limits.validate())
        return tl::unexpected(*problem);
    LimitRisks risks;
    for (std::size_t i = 0; i < risks.size(); ++i) {
        if (!limits.quantities[i])
            continue;
        ASSIGN_OR_RETURN(risks[i], quantityRisks(limits, *limits.quantities[i], knownValues(squeezes, i)));
    }
    return risks;
}

} // namespace gripscope
