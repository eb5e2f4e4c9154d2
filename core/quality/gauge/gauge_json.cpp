// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_value.h"
#include "core/math/matrix_json.h"
#include "core/quality/gauge/gauge_study.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonArray tableJson(const std::vector<VarianceRow>& table)
{
    QJsonArray rows;
    for (const VarianceRow& row : table)
        rows.append(QJsonObject{{u"source"_s, toString(row.source)},
                                {u"df"_s, jsonNumber(row.degreesOfFreedom)},
                                {u"ss"_s, jsonNumber(row.sumOfSquares)},
                                {u"ms"_s, jsonNumber(row.meanSquare)},
                                {u"f"_s, jsonNumber(row.f)},
                                {u"p"_s, jsonNumber(row.p)}});
    return rows;
}

QJsonObject componentJson(const VarianceComponent& component)
{
    QJsonObject object{{u"variance"_s, jsonNumber(component.estimate)},
                       {u"interval"_s, jsonInterval(component.interval.lower, component.interval.upper)},
                       {u"percent_contribution"_s, jsonNumber(component.percentContribution)},
                       {u"percent_study_variation"_s, jsonNumber(component.percentStudyVariation)},
                       {u"percent_tolerance"_s, jsonNumber(component.percentTolerance)}};
    if (component.estimate < 0)
        object[u"taken_as"_s] = component.taken;
    return object;
}

QJsonObject consistencyJson(const RepeatConsistency& found)
{
    return {{u"chi_squared"_s, jsonNumber(found.chiSquared)},
            {u"df"_s, jsonNumber(found.degreesOfFreedom)},
            {u"p_above"_s, jsonNumber(found.above)},
            {u"p_below"_s, jsonNumber(found.below)},
            {u"ratio"_s, jsonNumber(found.ratio)},
            {u"stated_deviation"_s, jsonNumber(found.statedDeviation)}};
}

QJsonObject valueJson(const GaugeValue& value)
{
    QJsonObject components;
    for (const VarianceComponent& one : value.components)
        components[toString(one.component)] = componentJson(one);
    QJsonArray pooled;
    for (const GaugeSource source : value.pooled)
        pooled.append(toString(source));
    QJsonObject object{{u"mean"_s, jsonNumber(value.mean)},
                       {u"anova"_s, tableJson(value.table)},
                       {u"components"_s, components},
                       {u"distinct_categories"_s,
                        QJsonObject{{u"value"_s, jsonNumber(value.distinctCategories)},
                                    {u"interval"_s, jsonInterval(value.distinctCategoriesInterval.lower,
                                                                 value.distinctCategoriesInterval.upper)}}},
                       {u"interaction_pooled"_s, !value.pooled.empty()},
                       {u"messages"_s, QJsonArray::fromStringList(english(value.messages))}};
    if (!value.pooled.empty()) {
        object[u"pooled"_s] = pooled;
        object[u"anova_pooled"_s] = tableJson(value.pooledTable);
    }
    if (value.consistency)
        object[u"repeat_consistency"_s] = consistencyJson(*value.consistency);
    return object;
}

QJsonObject jointJson(const GaugeStudy& study)
{
    QJsonObject object{{u"messages"_s, QJsonArray::fromStringList(english(study.jointMessages))},
                       {u"kinds"_s, QJsonValue::Null}};
    if (!study.joint)
        return object;
    QJsonArray directions;
    for (const JointDirection& direction : study.joint->directions) {
        QJsonObject weights;
        for (Eigen::Index j = 0; j < direction.weights.size(); ++j)
            weights[study.values[std::size_t(j)].name] = jsonNumber(direction.weights[j]);
        directions.append(QJsonObject{{u"ratio"_s, jsonNumber(direction.ratio)},
                                      {u"kinds"_s, jsonNumber(direction.kinds)},
                                      {u"weights"_s, weights}});
    }
    object[u"kinds"_s] = jsonNumber(study.joint->kinds);
    object[u"directions"_s] = directions;
    object[u"part_covariance"_s] = matrixJson(study.joint->part);
    object[u"gauge_covariance"_s] = matrixJson(study.joint->gauge);
    return object;
}

} // namespace

QJsonObject gaugeJson(const GaugeStudy& study)
{
    QJsonObject values;
    for (const GaugeValue& value : study.values)
        values[value.name] = valueJson(value);
    QJsonObject document{{u"design"_s, study.design == GaugeDesign::Nested ? u"nested"_s : u"crossed"_s},
                         {u"method"_s, toString(study.method)},
                         {u"balanced"_s, study.balanced},
                         {u"values"_s, values}};
    if (!study.jointMessages.empty())
        document[u"joint"_s] = jointJson(study);
    return document;
}

} // namespace gripscope
