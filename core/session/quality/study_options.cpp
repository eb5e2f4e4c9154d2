// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_options.h"

#include "core/base/json_value.h"

#include <QJsonArray>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr int mostMonths = 1200; // beyond the life of any gripper, and within every calendar
}

QJsonObject toJson(const StudyOptions& options)
{
    QJsonArray tolerances;
    for (const std::optional<double>& tolerance : options.tolerances)
        tolerances.append(jsonNumber(tolerance));
    return {{u"tolerances"_s, tolerances},
            {u"study_variation"_s, options.studyVariation},
            {u"pooling"_s, options.pooling},
            {u"repeat_after_months"_s, options.repeatAfterMonths}};
}

StudyOptions studyOptionsFromJson(const QJsonObject& json)
{
    StudyOptions options;
    const QJsonArray tolerances = json[u"tolerances"].toArray();
    for (std::size_t i = 0; i < options.tolerances.size(); ++i)
        if (const double width = tolerances.at(qsizetype(i)).toDouble(); width > 0)
            options.tolerances[i] = width;
    if (const double deviations = json[u"study_variation"].toDouble(); deviations > 0)
        options.studyVariation = deviations;
    options.pooling = json[u"pooling"].toBool(true);
    const int months = json[u"repeat_after_months"].toInt(options.repeatAfterMonths);
    if (months >= 0 && months <= mostMonths)
        options.repeatAfterMonths = months;
    return options;
}

} // namespace gripscope
