// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/early_decision_study_json.h"

#include "core/identification/json_number.h"

#include <QJsonArray>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject rowJson(const EarlyDecisionStudy& row)
{
    const EarlyDecisionSetting& setting = row.setting;
    return {{u"setting"_s, setting.name()},
            {u"noise_fit_percent"_s, setting.fitPercent},
            {u"noise_pole"_s, setting.noisePole},
            {u"start"_s, setting.restKnown ? u"rest"_s : u"free"_s},
            {u"longest_samples"_s, static_cast<qint64>(setting.longest)},
            {u"scatter"_s, setting.scatter},
            {u"enrolled"_s, setting.enrolled},
            {u"runs"_s, row.runs},
            {u"strangers"_s, row.strangers},
            {u"decided"_s, row.decided},
            {u"undecided"_s, row.runs - row.decided},
            {u"wrong"_s, row.wrong},
            {u"wrong_types"_s, row.wrongTypes},
            {u"strangers_accepted"_s, row.strangersAccepted},
            {u"known_called_unknown"_s, row.knownCalledStrangers},
            {u"mean_samples"_s, row.meanSamples},
            {u"median_samples"_s, row.medianSamples},
            {u"90_percent_samples"_s, row.ninetyPercentSamples},
            {u"wrong_when_forced"_s, row.wrongWhenForced},
            {u"equal_fixed_length"_s,
             row.equalFixedLength ? QJsonValue(static_cast<qint64>(*row.equalFixedLength)) : QJsonValue()},
            {u"saving"_s, jsonNumber(row.saving)}};
}

} // namespace

QJsonObject toJson(const std::vector<EarlyDecisionStudy>& rows, const EarlyDecisionStudyOptions& options)
{
    QJsonArray settings;
    for (const EarlyDecisionStudy& row : rows)
        settings.append(rowJson(row));
    return {{u"study"_s, u"early"_s},
            {u"runs"_s, options.runs},
            {u"seed"_s, static_cast<qint64>(options.seed)},
            {u"stated_error"_s, options.statedError},
            {u"stranger_share"_s, options.strangerShare},
            {u"settings"_s, settings}};
}

} // namespace gripscope
