// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validation_json.h"

#include "core/identification/json_number.h"
#include "core/json_text.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject windowJson(const Window& window)
{
    return {{u"first"_s, static_cast<qint64>(window.first)},
            {u"samples"_s, static_cast<qint64>(window.count)}};
}

QJsonValue byName(const std::optional<Eigen::Vector3d>& values)
{
    if (!values)
        return QJsonValue();
    return QJsonObject{{u"m"_s, jsonNumber((*values)(0))},
                       {u"b"_s, jsonNumber((*values)(1))},
                       {u"k"_s, jsonNumber((*values)(2))}};
}

QJsonValue parametersJson(const Validation& validation)
{
    if (!validation.available())
        return QJsonValue();
    QJsonObject object = byName(validation.parameters.vector()).toObject();
    if (validation.k3)
        object.insert(u"k3"_s, jsonNumber(*validation.k3));
    return object;
}

} // namespace

QJsonObject toJson(const Validation& validation)
{
    return {
        {u"on"_s, toString(validation.source)},
        {u"file"_s, jsonText(validation.name)},
        {u"as_expected"_s, validation.asExpected ? QJsonValue(*validation.asExpected) : QJsonValue()},
        {u"message"_s, validation.message},
        {u"estimator"_s, toString(validation.estimator)},
        {u"parameters"_s, parametersJson(validation)},
        {u"estimated_on"_s, windowJson(validation.estimatedOn)},
        {u"validated_on"_s, windowJson(validation.validatedOn)},
        {u"fit"_s, QJsonObject{{u"simulation_percent"_s, jsonNumber(validation.fit.simulationPercent)},
                               {u"prediction_percent"_s, jsonNumber(validation.fit.predictionPercent)},
                               {u"expected_percent"_s, jsonNumber(validation.expectedPercent)}}},
        {u"residuals"_s, QJsonObject{{u"whiteness_p"_s, jsonNumber(validation.whitenessP)},
                                     {u"input_independence_p"_s, jsonNumber(validation.inputIndependenceP)}}},
        {u"misfit"_s, QJsonObject{{u"p"_s, jsonNumber(validation.misfitP)},
                                  {u"root_f"_s, jsonNumber(validation.misfit)},
                                  {u"change"_s, byName(validation.change)},
                                  {u"change_errors"_s, byName(validation.changeErrors)}}},
        {u"nuisance"_s, QJsonObject{{u"x0"_s, jsonNumber(validation.nuisance.x0)},
                                    {u"v0"_s, jsonNumber(validation.nuisance.v0)},
                                    {u"offset"_s, jsonNumber(validation.nuisance.offset)}}}};
}

} // namespace gripscope
