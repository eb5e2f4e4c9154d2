// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/study/study_commands.h"
#include "core/math/binomial_evidence.h"
#include "core/research/recognition_study.h"
#include "core/research/study_json.h"

#include <QString>
#include <QStringList>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QString ratePercent(double share)
{
    return QString::number(100 * share, 'g', 3) + u" %"_qs;
}

QString bounds(const StudyLimit& limit)
{
    if (limit.least && limit.most)
        return u"%1 to %2"_qs.arg(*limit.least).arg(*limit.most);
    return limit.least ? u"at least %1"_qs.arg(*limit.least) : u"at most %1"_qs.arg(limit.most.value_or(0));
}

/// Nothing for a figure that is shown only.
QString held(const StudyLimit& limit)
{
    if (!limit.least && !limit.most)
        return {};
    return u", wanted %1: %2"_qs.arg(bounds(limit), limit.met() ? u"met"_qs : u"not met"_qs);
}

QString rowText(const RecognitionRow& row)
{
    QStringList shares;
    for (auto it = row.tally.shares.cbegin(); it != row.tally.shares.cend(); ++it)
        shares << u"%1 %2 (+- %3)"_qs.arg(it.key(), ratePercent(it->share), ratePercent(it->standardError));
    QString text = u"%1: %2"_qs.arg(row.scenario.name(), shares.join(u", "_qs));
    for (const StudyLimit& limit : row.limits)
        text += u"\n    %1 %2 +- %3%4"_qs.arg(limit.figure, QString::number(limit.value, 'g', 3),
                                              QString::number(limit.standardError, 'g', 2), held(limit));
    return text;
}

/// The study's rows for a person: what was counted, and the limits.
QString recognitionText(const RecognitionStudy& study)
{
    QStringList lines{
        u"Stated rates and found ones, over fresh enrolments of four types; names are scenario, "
        "squeezes a type and stated rate. Standard errors are clustered by enrolment."_qs};
    for (const RecognitionRow& row : study.rows)
        lines << rowText(row);
    const PaperRecognition& paper = study.paper;
    lines << u"Paper's appendix: %1 of %2 right when left out, %3 unknown when their type is left out, %4 "
             "refused by models fitted to them. Left out, %5"_qs.arg(
                 QString::number(paper.leaveOneOutCorrect), QString::number(paper.squeezes),
                 QString::number(paper.leftOutTypeUnknown), QString::number(paper.rejectedInTraining),
                 inWords(binomialEvidence(paper.squeezes - paper.leaveOneOutCorrect, paper.squeezes),
                         VerdictOptions{}.wrongType)
                     .describe());
    return lines.join(u'\n');
}

} // namespace

int runRecognitionStudy(const QStringList& arguments)
{
    CommandLine line(u"study recognition"_qs,
                     u"Repeats enrolments and inspections of types with known scatter: the rates a verdict "
                     "states beside those that are found."_qs);
    RecognitionStudyOptions options;
    addStudyOptions(line, options.runs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    readStudyOptions(line, options);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    options.progress = [](int done, int rows) { message(u"%1 of %2 rows"_qs.arg(done).arg(rows)); };
    const RecognitionStudy study = studyRecognition(options);
    if (line.isSet(u"json"_qs))
        printJson(toJson(study, options));
    else
        print(recognitionText(study));
    return 0;
}

} // namespace gripscope::cli
