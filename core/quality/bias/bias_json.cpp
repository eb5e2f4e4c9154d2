// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/bias/bias_json.h"

#include "core/base/json_value.h"

#include <QJsonArray>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonValue intervalJson(const std::optional<TwoSidedInterval>& interval)
{
    return interval ? QJsonValue(jsonInterval(interval->lower, interval->upper)) : QJsonValue();
}

QJsonObject biasJson(const ReferenceBias& bias)
{
    return {{u"reference"_s, bias.reference},
            {u"count"_s, qint64(bias.count)},
            {u"bias"_s, bias.bias},
            {u"deviation"_s, jsonNumber(bias.deviation)},
            {u"t"_s, jsonNumber(bias.t)},
            {u"p"_s, jsonNumber(bias.p)},
            {u"interval"_s, intervalJson(bias.interval)},
            {u"line"_s, jsonNumber(bias.line)},
            {u"band"_s, intervalJson(bias.band)},
            {u"percent_bias"_s, jsonNumber(bias.percentBias)}};
}

QJsonValue testJson(const std::optional<LinearityTest>& test)
{
    if (!test)
        return QJsonValue::Null;
    return QJsonObject{{u"f"_s, test->f},
                       {u"numerator_df"_s, test->numerator},
                       {u"denominator_df"_s, test->denominator},
                       {u"p"_s, jsonNumber(test->p)}};
}

} // namespace

QJsonObject toJson(const TypeOneStudy& study)
{
    return {{u"count"_s, qint64(study.count)},
            {u"mean"_s, study.mean},
            {u"bias"_s, study.bias},
            {u"bias_interval"_s, intervalJson(study.biasInterval)},
            {u"t"_s, jsonNumber(study.t)},
            {u"p"_s, jsonNumber(study.p)},
            {u"repeatability"_s, study.repeatability},
            {u"repeatability_interval"_s, intervalJson(study.repeatabilityInterval)},
            {u"cg"_s, jsonNumber(study.cg)},
            {u"cg_interval"_s, intervalJson(study.cgInterval)},
            {u"cgk"_s, jsonNumber(study.cgk)},
            {u"cgk_interval"_s, intervalJson(study.cgkInterval)},
            {u"percent_variation"_s, jsonNumber(study.variationPercent)},
            {u"percent_variation_with_bias"_s, jsonNumber(study.biasedVariationPercent)},
            {u"largest_percent_variation"_s, study.largestVariationPercent},
            {u"least_tolerance_cg"_s, study.leastTolerance},
            {u"least_tolerance_cgk"_s, study.leastBiasedTolerance},
            {u"step"_s, jsonNumber(study.step)},
            {u"step_percent_tolerance"_s, jsonNumber(study.stepPercent)},
            {u"capable"_s, study.capable},
            {u"messages"_s, QJsonArray::fromStringList(english(study.messages))}};
}

QJsonObject toJson(const LinearityStudy& study)
{
    QJsonArray biases;
    for (const ReferenceBias& bias : study.references)
        biases.append(biasJson(bias));
    return {{u"count"_s, qint64(study.count)},
            {u"intercept"_s, study.intercept},
            {u"slope"_s, study.slope},
            {u"residual_deviation"_s, jsonNumber(study.residualDeviation)},
            {u"r_squared"_s, jsonNumber(study.rSquared)},
            {u"t_intercept"_s, jsonNumber(study.tIntercept)},
            {u"t_slope"_s, jsonNumber(study.tSlope)},
            {u"p_intercept"_s, jsonNumber(study.pIntercept)},
            {u"p_slope"_s, jsonNumber(study.pSlope)},
            {u"bias"_s, biases},
            {u"average_bias"_s, biasJson(study.average)},
            {u"pooled_deviation"_s, jsonNumber(study.pooledDeviation)},
            {u"percent_linearity"_s, study.percentLinearity},
            {u"linearity"_s, jsonNumber(study.linearity)},
            {u"lack_of_fit"_s, testJson(study.lackOfFit)},
            {u"zero_line"_s, testJson(study.zeroLine)},
            {u"messages"_s, QJsonArray::fromStringList(english(study.messages))}};
}

} // namespace gripscope
