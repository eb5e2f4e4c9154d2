// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/study_json.h"

#include "core/base/json_value.h"
#include "core/identification/design/excitation_design.h"
#include "core/math/binomial_evidence.h"
#include "core/research/early_decision_study.h"
#include "core/research/efficiency_study.h"
#include "core/research/model_efficiency.h"
#include "core/research/recognition_study.h"
#include "core/research/truth_study.h"

#include <QJsonArray>

#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject candidateJson(const DesignCandidate& candidate, const DesignOptions& options)
{
    QJsonObject errors;
    for (std::size_t i = 0; i < options.objects.size(); ++i) {
        const std::optional<Eigen::Vector3d>& e = candidate.standardErrors[i];
        errors[options.objects[i].name] =
            e ? QJsonValue(QJsonObject{{u"m"_s, (*e)(0)}, {u"b"_s, (*e)(1)}, {u"k"_s, (*e)(2)}})
              : QJsonValue();
    }
    QJsonValue separation, nearest;
    if (options.objects.size() > 1) {
        separation = candidate.separation;
        const auto name = [&](int index) { return options.objects[static_cast<std::size_t>(index)].name; };
        nearest = QJsonArray{name(candidate.nearestFirst), name(candidate.nearestSecond)};
        if (candidate.nearestFirst == candidate.nearestSecond)
            nearest = QJsonValue();
    }
    return {{u"excitation"_s, toString(candidate.kind)},
            {u"bit_s"_s, candidate.bit_s > 0 ? QJsonValue(candidate.bit_s) : QJsonValue()},
            {u"d_efficiency"_s, candidate.dEfficiency},
            {u"separation"_s, separation},
            {u"nearest"_s, nearest},
            {u"standard_errors"_s, errors}};
}

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

QJsonObject limitJson(const StudyLimit& limit)
{
    return {{u"figure"_s, limit.figure},
            {u"value"_s, jsonNumber(limit.value)},
            {u"standard_error"_s, jsonNumber(limit.standardError)},
            {u"least"_s, jsonNumber(limit.least)},
            {u"most"_s, jsonNumber(limit.most)},
            {u"met"_s, limit.met()}};
}

QJsonObject rowJson(const RecognitionRow& row)
{
    QJsonObject shares;
    for (auto it = row.tally.shares.cbegin(); it != row.tally.shares.cend(); ++it)
        shares[it.key()] = QJsonObject{{u"share"_s, jsonNumber(it->share)},
                                       {u"standard_error"_s, jsonNumber(it->standardError)},
                                       {u"count"_s, jsonNumber(it->count)}};
    QJsonArray limits;
    for (const StudyLimit& limit : row.limits)
        limits.append(limitJson(limit));
    QJsonObject json{{u"row"_s, row.scenario.name()},
                     {u"scenario"_s, toString(row.scenario.kind)},
                     {u"squeezes_a_type"_s, row.scenario.squeezes},
                     {u"stated"_s, row.scenario.statedRate()},
                     {u"robust"_s, row.scenario.options.robust},
                     {u"confidence"_s, jsonNumber(row.scenario.options.confidence)},
                     {u"enrolments"_s, row.tally.enrolments},
                     {u"cases"_s, jsonNumber(row.tally.cases)},
                     {u"shares"_s, shares},
                     {u"limits"_s, limits}};
    if (row.scenario.space != QuantitySpace{})
        json[u"space"_s] = toString(row.scenario.space);
    if (row.scenario.kind == ScenarioKind::Strangers)
        json[u"deviations"_s] = row.scenario.deviations;
    if (row.tally.shares.contains(u"wrong_type"_s) && row.scenario.kind != ScenarioKind::Strangers) {
        const auto wrong = std::int64_t(row.tally.shares[u"wrong_type"_s].count);
        json[u"wrong_type_shown"_s] =
            inWords(binomialEvidence(wrong, std::int64_t(row.tally.cases)), row.scenario.options.wrongType)
                .english();
    }
    return json;
}

} // namespace

QJsonObject toJson(const ExcitationDesign& design, const DesignOptions& options)
{
    QJsonArray candidates;
    for (const DesignCandidate& candidate : design.candidates)
        candidates.append(candidateJson(candidate, options));
    QJsonArray force;
    if (!design.candidates.empty())
        for (const double value : design.candidates.front().force)
            force.append(value);
    return {{u"samples"_s, static_cast<qint64>(options.samples())},
            {u"sample_time_s"_s, options.sampleTime_s},
            {u"peak"_s, design.amplitude},
            {u"bias"_s, options.bias},
            {u"limit"_s, options.limit},
            {u"candidates"_s, candidates},
            {u"force"_s, force}};
}

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

QJsonObject toJson(const RecognitionStudy& study, const RecognitionStudyOptions& options)
{
    QJsonArray rows;
    bool met = true;
    for (const RecognitionRow& row : study.rows) {
        rows.append(rowJson(row));
        for (const StudyLimit& limit : row.limits)
            met = met && limit.met();
    }
    const PaperRecognition& paper = study.paper;
    return {{u"study"_s, u"recognition"_s},
            {u"runs"_s, options.runs},
            {u"seed"_s, static_cast<qint64>(options.seed)},
            {u"standard_errors"_s, u"clustered by enrolment"_s},
            {u"noise_mismatch"_s, u"each squeeze simulated and identified by output error"_s},
            {u"rows"_s, rows},
            {u"all_limits_met"_s, met},
            {u"paper"_s,
             QJsonObject{{u"squeezes"_s, paper.squeezes},
                         {u"leave_one_out_correct"_s, paper.leaveOneOutCorrect},
                         {u"left_out_type_unknown"_s, paper.leftOutTypeUnknown},
                         {u"rejected_in_training"_s, paper.rejectedInTraining},
                         {u"leave_one_out_shown"_s,
                          inWords(binomialEvidence(paper.squeezes - paper.leaveOneOutCorrect, paper.squeezes),
                                  VerdictOptions{}.wrongType)
                              .english()}}}};
}

QJsonObject toJson(const ModelEfficiencyStudy& study, const ModelEfficiencyOptions& options)
{
    QJsonArray rows;
    for (const ModelEfficiencyRow& row : study.rows) {
        QJsonObject parameters;
        const bool any = row.used > 0;
        for (const ModelParameterEfficiency& p : row.parameters)
            parameters[toString(p.parameter)] =
                QJsonObject{{u"truth"_s, p.truth},
                            {u"bound"_s, known(any, p.bound)},
                            {u"ratio"_s, known(any, p.ratio)},
                            {u"coverage_percent"_s, known(any, p.coveragePercent)}};
        QJsonObject failed;
        for (const auto& [status, count] : row.failed)
            failed[toString(status)] = count;
        const bool rubs = parameters.contains(toString(MotionParameter::Friction));
        rows.append(QJsonObject{{u"setting"_s, row.setting.squeeze.name},
                                {u"estimator"_s, toString(row.setting.estimator)},
                                {u"runs"_s, row.runs},
                                {u"used"_s, row.used},
                                {u"failed"_s, failed},
                                {u"near_zero"_s, row.nearZero},
                                {u"friction_limit_percent"_s, known(any && rubs, row.limitPercent)},
                                {u"parameters"_s, parameters}});
    }
    QJsonArray pooled;
    for (const PooledModelEfficiency& one : study.pooled)
        pooled.append(QJsonObject{{u"estimator"_s, toString(one.estimator)},
                                  {u"runs"_s, static_cast<qint64>(one.runs)},
                                  {u"used"_s, static_cast<qint64>(one.used)},
                                  {u"ratio"_s, known(one.used > 0, one.ratio)},
                                  {u"coverage_percent"_s, known(one.used > 0, one.coveragePercent)},
                                  {u"friction_limit_percent"_s,
                                   known(one.limitPercent.has_value(), one.limitPercent.value_or(0))}});
    return {{u"runs"_s, options.runs},
            {u"seed"_s, static_cast<qint64>(options.seed)},
            {u"rows"_s, rows},
            {u"pooled"_s, pooled}};
}

QJsonObject toJson(const TruthStudy& study, const TruthStudyOptions& options)
{
    QJsonArray rows;
    for (const TruthRow& row : study.rows) {
        QJsonObject covered;
        QJsonObject largest;
        for (std::size_t i = 0; i < parameterNames.size(); ++i) {
            covered[parameterNames[i]] = row.covered[i] + row.coveredWidened[i];
            largest[parameterNames[i]] = known(row.valid > 0, row.largestError[i]);
        }
        rows.append(QJsonObject{{u"setting"_s, row.setting.name},
                                {u"in_family"_s, row.setting.inFamily},
                                {u"runs"_s, row.runs},
                                {u"valid"_s, row.valid},
                                {u"suspect"_s, row.suspect},
                                {u"invalid"_s, row.invalid},
                                {u"lies"_s, row.lies},
                                {u"widened"_s, row.widened},
                                {u"covered"_s, covered},
                                {u"largest_error"_s, largest}});
    }
    return {{u"runs"_s, options.runs},
            {u"seed"_s, static_cast<qint64>(options.seed)},
            {u"rows"_s, rows},
            {u"valid"_s, study.valid},
            {u"lies"_s, study.lies},
            {u"coverage_percent"_s, known(study.valid > 0, study.coveredPercent)},
            {u"coverage_widened_percent"_s, known(study.valid > 0, study.coveredWidenedPercent)},
            {u"valid_in_family_percent"_s, known(study.runs > 0, study.validInFamilyPercent)}};
}

} // namespace gripscope
