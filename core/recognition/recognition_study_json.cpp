// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/recognition_study_json.h"

#include "core/identification/json_number.h"
#include "core/recognition/binomial_evidence.h"

#include <QJsonArray>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

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
    if (row.scenario.kind == ScenarioKind::Strangers)
        json[u"deviations"_s] = row.scenario.deviations;
    if (row.tally.shares.contains(u"wrong_type"_s) && row.scenario.kind != ScenarioKind::Strangers) {
        const auto wrong = std::int64_t(row.tally.shares[u"wrong_type"_s].count);
        json[u"wrong_type_shown"_s] =
            inWords(binomialEvidence(wrong, std::int64_t(row.tally.cases)), row.scenario.options.wrongType);
    }
    return json;
}

} // namespace

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
                                  VerdictOptions{}.wrongType)}}}};
}

} // namespace gripscope
