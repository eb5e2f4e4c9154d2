// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library_private.h"
#include "core/library/tables/document_table.h"
#include "core/library/tables/grasp_table.h"
#include "core/signal/recording/units.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::optional<double> numberOf(const QJsonObject& object, const QString& key)
{
    const QJsonValue value = object.value(key);
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

/// As the budget that was stored with the squeeze has it; nothing where that has no budget.
std::optional<MeasuredValue> byStoredBudget(const QJsonObject& budget, const QString& symbol)
{
    const std::optional<double> value = numberOf(budget.value(u"parameters"_s).toObject(), symbol);
    const QJsonObject interval = budget.value(u"intervals"_s).toObject().value(symbol).toObject();
    if (!value || interval.value(u"only_upper_bound"_s).toBool())
        return {};
    return MeasuredValue{*value, numberOf(budget.value(u"standard_uncertainties"_s).toObject(), symbol),
                         numberOf(budget.value(u"degrees_of_freedom"_s).toObject(), symbol)};
}

std::optional<MeasuredValue> byEstimate(const GraspRecord& grasp, std::size_t place)
{
    if (!grasp.parameters)
        return {};
    const auto at = static_cast<Eigen::Index>(place);
    MeasuredValue measured{grasp.parameters->vector()[at]};
    if (grasp.covariance && (*grasp.covariance)(at, at) > 0)
        measured.standardUncertainty = std::sqrt((*grasp.covariance)(at, at));
    return measured;
}

/// From the units of the squeeze to those of its type, which can be compared.
double factorToType(const GraspRecord& grasp, const TypeRecord& type)
{
    const std::optional<double> own = siFactor(grasp.forceUnit, grasp.positionUnit);
    const std::optional<double> wanted = siFactor(type.forceUnit, type.positionUnit);
    return own && wanted ? *own / *wanted : 1;
}

MeasuredValues measuredOf(const GraspRecord& grasp, const QJsonObject& document, const TypeRecord& type)
{
    const QJsonObject budget = document.value(u"budget"_s).toObject();
    const double factor = factorToType(grasp, type);
    MeasuredValues measured;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        measured[i] = budget.value(u"parameters"_s).isObject() ? byStoredBudget(budget, quantitySymbol(i))
                                                               : byEstimate(grasp, i);
        if (!measured[i])
            continue;
        measured[i]->value *= factor;
        if (std::optional<double>& u = measured[i]->standardUncertainty)
            *u *= factor;
    }
    return measured;
}

} // namespace

Expected<std::vector<MeasuredValues>> Library::measuredSqueezes(const TypeRecord& type) const
{
    ASSIGN_OR_RETURN(const auto grasps, grasp_table::ofType(*d->database, type.id));
    std::vector<MeasuredValues> measured;
    for (const GraspRecord& grasp : grasps) {
        if (!grasp.accepted)
            continue;
        ASSIGN_OR_RETURN(const QJsonObject document, document_table::read(*d->database, grasp.id));
        measured.push_back(measuredOf(grasp, document, type));
    }
    return measured;
}

Expected<LimitRisks> Library::typeRisks(const TypeRecord& type, const PartLimits& limits) const
{
    ASSIGN_OR_RETURN(const auto measured, measuredSqueezes(type));
    return limitRisks(limits, measured);
}

} // namespace gripscope
