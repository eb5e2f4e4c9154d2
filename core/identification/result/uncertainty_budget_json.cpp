// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_value.h"
#include "core/identification/result/identification_json.h"
#include "core/math/matrix_json.h"

#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject budgetByName(const QJsonValue& m, const QJsonValue& b, const QJsonValue& k)
{
    return {{u"m"_s, m}, {u"b"_s, b}, {u"k"_s, k}};
}

QJsonObject budgetByName(const Eigen::Vector3d& values)
{
    return budgetByName(jsonNumber(values(0)), jsonNumber(values(1)), jsonNumber(values(2)));
}

QJsonObject toJson(const CoverageInterval& interval)
{
    return {{u"lower"_s, jsonNumber(interval.lower)},
            {u"upper"_s, jsonNumber(interval.upper)},
            {u"logarithmic"_s, interval.logarithmic},
            {u"only_upper_bound"_s, interval.onlyUpperBound}};
}

QJsonObject toJson(const BudgetLine& line)
{
    return {{u"id"_s, line.id},
            {u"message"_s, line.words.english()},
            {u"type"_s, toString(line.type)},
            {u"standard_uncertainties"_s, budgetByName(line.standardUncertainties())},
            {u"covariance"_s, matrixJson(line.covariance)},
            {u"degrees_of_freedom"_s,
             line.degreesOfFreedom ? QJsonValue(budgetByName(*line.degreesOfFreedom)) : QJsonValue()},
            {u"share"_s, budgetByName(line.share)}};
}

template <typename Member>
QJsonObject combined(const UncertaintyBudget& budget, Member member)
{
    const std::array<CombinedUncertainty, 3>& c = budget.combined;
    return budgetByName(jsonNumber(c[0].*member), jsonNumber(c[1].*member), jsonNumber(c[2].*member));
}

QJsonObject toJson(const ComparedModel& model)
{
    const std::optional<MassDampingStiffness>& p = model.estimate.parameters;
    return {{u"id"_s, model.id},
            {u"message"_s, model.words.english()},
            {u"parameters"_s, p ? QJsonValue(budgetByName(p->vector())) : QJsonValue()},
            {u"unknowns"_s, model.parameters},
            {u"noise_order"_s, model.noiseOrder},
            {u"log_likelihood"_s, jsonNumber(model.logLikelihood)},
            {u"criterion"_s, jsonNumber(model.criterion)},
            {u"delta"_s, jsonNumber(model.delta)},
            {u"weight"_s, jsonNumber(model.weight)},
            {u"change_in_standard_errors"_s, jsonNumber(model.change)},
            {u"delay_s"_s, jsonNumber(model.delay_s)}};
}

} // namespace

QJsonObject toJson(const UncertaintyBudget& budget)
{
    QJsonArray lines;
    for (const BudgetLine& line : budget.lines)
        lines.append(toJson(line));
    QJsonObject out{{u"coverage"_s, jsonNumber(budget.coverage)},
                    {u"message"_s, budget.message.english()},
                    {u"lines"_s, lines}};
    const bool there = budget.parameters.has_value();
    const auto orNull = [&](const QJsonValue& value) { return there ? value : QJsonValue(); };
    out[u"covariance"_s] = orNull(matrixJson(budget.covariance));
    const auto put = [&](const QString& name, const QJsonObject& linear, auto further) {
        QJsonObject all = there ? linear : budgetByName({}, {}, {});
        for (const FurtherParameter& one : budget.further)
            all[toString(one.parameter)] = further(one);
        out[name] = there || !budget.further.empty() ? QJsonValue(all) : QJsonValue();
    };
    put(u"parameters"_s, there ? budgetByName(budget.parameters->vector()) : QJsonObject(),
        [](const FurtherParameter& one) { return jsonNumber(one.value); });
    const auto putCombined = [&](const QString& name, auto member) {
        put(name, combined(budget, member),
            [&](const FurtherParameter& one) { return jsonNumber(one.combined.*member); });
    };
    putCombined(u"standard_uncertainties"_s, &CombinedUncertainty::standardUncertainty);
    putCombined(u"degrees_of_freedom"_s, &CombinedUncertainty::degreesOfFreedom);
    putCombined(u"coverage_factors"_s, &CombinedUncertainty::coverageFactor);
    put(u"intervals"_s,
        budgetByName(toJson(budget.intervals[0]), toJson(budget.intervals[1]), toJson(budget.intervals[2])),
        [](const FurtherParameter& one) { return toJson(one.interval); });
    return out;
}

QJsonObject toJson(const std::vector<DerivedQuantity>& quantities)
{
    QJsonObject out;
    for (const DerivedQuantity& quantity : quantities) {
        out[quantity.id] =
            QJsonObject{{u"name"_s, quantity.name.english()},
                        {u"unit"_s, quantity.unit},
                        {u"value"_s, jsonNumber(quantity.value)},
                        {u"standard_uncertainty"_s, jsonNumber(quantity.uncertainty.standardUncertainty)},
                        {u"lower"_s, jsonNumber(quantity.interval.lower)},
                        {u"upper"_s, jsonNumber(quantity.interval.upper)},
                        {u"degrees_of_freedom"_s, jsonNumber(quantity.uncertainty.degreesOfFreedom)},
                        {u"message"_s, quantity.words.english()}};
    }
    return out;
}

QJsonObject toJson(const ModelComparison& comparison)
{
    QJsonArray models;
    for (const ComparedModel& model : comparison.ranked)
        models.append(toJson(model));
    return {{u"criterion"_s, comparison.criterion},
            {u"decisive"_s, comparison.decisive},
            {u"message"_s, comparison.sentence.english()},
            {u"models"_s, models}};
}

} // namespace gripscope
