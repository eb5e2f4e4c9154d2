// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/efficiency_study_json.h"

#include <QJsonArray>

#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const std::array<QString, 3> parameterNames{u"m"_s, u"b"_s, u"k"_s};

QJsonValue known(bool exists, double value)
{
    return exists ? QJsonValue(value) : QJsonValue();
}

QJsonObject excitationJson(const SettingEfficiency& row)
{
    QJsonObject json{{u"kind"_s, toString(row.setting.excitation)}, {u"hold"_s, toString(ForceHold::Zero)}};
    if (row.experiment.harmonics.empty()) {
        json[u"bit_s"_s] = efficiencyBit_s;
        return json;
    }
    QJsonArray harmonics;
    for (const int harmonic : row.experiment.harmonics)
        harmonics.append(harmonic);
    json[u"fundamental_rad_s"_s] = row.experiment.fundamental_rad_s;
    json[u"harmonics"_s] = harmonics;
    return json;
}

QJsonObject rowJson(const SettingEfficiency& row)
{
    QJsonObject parameters;
    for (std::size_t i = 0; i < parameterNames.size(); ++i) {
        const ParameterEfficiency& p = row.parameters[i];
        const bool any = row.used > 0;
        parameters[parameterNames[i]] = QJsonObject{
            {u"truth"_s, p.truth},
            {u"bound"_s, p.bound},
            {u"bias"_s, known(any, p.bias)},
            {u"rmse"_s, known(any, p.rootMeanSquareError)},
            {u"ratio"_s, known(any, p.ratio)},
            {u"coverage_percent"_s, known(any, p.coveragePercent)},
            {u"log_coverage_percent"_s, known(any, p.logCoveragePercent)},
        };
    }
    QJsonObject failed;
    for (const auto& [status, count] : row.failed)
        failed[toString(status)] = count;
    return {{u"setting"_s, row.setting.name()},
            {u"type"_s, row.setting.type},
            {u"excitation"_s, excitationJson(row)},
            {u"noise_fit_percent"_s, row.setting.fitPercent},
            {u"noise_sd"_s, row.experiment.noiseDeviation},
            {u"samples"_s, static_cast<qint64>(row.setting.samples)},
            {u"sample_time_s"_s, row.setting.sampleTime_s},
            {u"estimator"_s, toString(row.estimator)},
            {u"runs"_s, row.runs},
            {u"used"_s, row.used},
            {u"failed"_s, failed},
            {u"parameters"_s, parameters}};
}

QJsonObject pooledJson(const PooledEfficiency& pooled)
{
    const bool any = pooled.used > 0;
    QJsonValue worst;
    if (any)
        worst = QJsonObject{{u"setting"_s, pooled.worstSetting},
                            {u"parameter"_s, parameterNames[static_cast<std::size_t>(pooled.worstParameter)]},
                            {u"ratio"_s, pooled.worstRatio}};
    return {{u"estimator"_s, toString(pooled.estimator)},
            {u"runs"_s, static_cast<qint64>(pooled.runs)},
            {u"used"_s, static_cast<qint64>(pooled.used)},
            {u"ratio"_s, known(any, pooled.ratio)},
            {u"worst"_s, worst},
            {u"coverage_percent"_s, known(any, pooled.coveragePercent)},
            {u"log_coverage_percent"_s, known(any, pooled.logCoveragePercent)}};
}

} // namespace

QJsonObject toJson(const EfficiencyStudy& study, const EfficiencyOptions& options)
{
    QJsonArray rows;
    for (const SettingEfficiency& row : study.rows)
        rows.append(rowJson(row));
    QJsonArray pooled;
    for (const PooledEfficiency& one : study.pooled)
        pooled.append(pooledJson(one));
    return {{u"study"_s, u"efficiency"_s},
            {u"runs"_s, options.runs},
            {u"seed"_s, static_cast<qint64>(options.seed)},
            {u"free"_s, QJsonArray{u"x0"_s, u"v0"_s, u"offset"_s}},
            {u"interval"_s, u"95 %: estimate +- t s, t of Student with N - p degrees of freedom"_s},
            {u"settings"_s, rows},
            {u"pooled"_s, pooled}};
}

} // namespace gripscope
