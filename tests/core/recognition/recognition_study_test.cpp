// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_runs.h"
#include "core/research/recognition_study.h"
#include "core/research/study_json.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

class RecognitionStudyTest : public QObject {
    Q_OBJECT
private slots:
    void standardErrorsAreThoseOfEnrolments()
    {
        // All of an enrolment or nothing: 4 independent cases, not 40.
        std::vector<EnrolmentTally> tallies;
        for (int i = 0; i < 4; ++i)
            tallies.push_back({10, {{u"a"_s, i < 2 ? 10.0 : 0.0}}});
        const ClusteredShare share = pooled(tallies).shares[u"a"_s];
        QCOMPARE(share.share, 0.5);
        QVERIFY(std::abs(share.standardError - std::sqrt(0.25 / 4)) < 1e-12);
        QVERIFY(pooled({}).shares.isEmpty());
    }
    void oneSeedGivesOneResultWhateverTheThreads()
    {
        RecognitionStudyOptions options;
        options.runs = 2;
        options.threads = 1;
        const RecognitionStudy one = studyRecognition(options);
        options.threads = 2;
        const RecognitionStudy two = studyRecognition(options);
        QCOMPARE(QJsonDocument(toJson(one, options)).toJson(), QJsonDocument(toJson(two, options)).toJson());
        options.seed = 2;
        QVERIFY(QJsonDocument(toJson(studyRecognition(options), options)).toJson() !=
                QJsonDocument(toJson(one, options)).toJson());
    }
    void thePaperIsRecognizedWhole()
    {
        RecognitionStudyOptions options;
        options.runs = 1;
        const RecognitionStudy study = studyRecognition(options);
        QCOMPARE(study.paper.leaveOneOutCorrect, 40);
        QCOMPARE(study.paper.leftOutTypeUnknown, 40);
        QVERIFY(study.paper.rejectedInTraining <= 0.01 * 40);
        const QJsonObject json = toJson(study, options);
        QCOMPARE(json[u"rows"_s].toArray().size(), qsizetype(study.rows.size()));
        QVERIFY(json[u"paper"_s][u"leave_one_out_shown"_s].toString().startsWith(
            u"0 wrong of 40: at most 7.2 %"_s));
    }
    void aRowThatAlwaysSaysInconclusiveFailsItsLimits()
    {
        RecognitionStudyOptions options;
        options.runs = 20;
        options.threads = 1;
        for (const ScenarioKind kind : {ScenarioKind::KnownParts, ScenarioKind::Neighbours}) {
            RecognitionScenario scenario;
            scenario.kind = kind;
            scenario.squeezes = 1; // no scatter is known: nothing is ever named or refused
            scenario.options.siUnits = false;
            scenario.options.wrongType = 0.01;
            const RecognitionRow row = studyRow(scenario, options);
            QCOMPARE(row.tally.shares[u"inconclusive"_s].share, 1.0);
            QVERIFY(!row.limits.empty());
            bool met = true;
            for (const StudyLimit& limit : row.limits)
                met = met && limit.met();
            QVERIFY2(!met, qPrintable(scenario.name()));
        }
    }
    void whatIsNamedStandsBesideBothOracles()
    {
        RecognitionStudyOptions options;
        options.runs = 20;
        options.threads = 1;
        RecognitionScenario scenario;
        scenario.kind = ScenarioKind::Neighbours;
        scenario.options.siUnits = false;
        scenario.options.wrongType = 0.01;
        for (const bool unlike : {false, true}) {
            scenario.unlikeScatter = unlike;
            const RecognitionRow row = studyRow(scenario, options);
            const StudyLimit& shown = row.limits.back();
            QCOMPARE(shown.figure, u"decided / oracle_rate's"_s);
            QVERIFY(shown.met() && shown.value > 0.5 && shown.value < 1.2);
            // Who names as many as the rate allows is mistaken that often, and names more than the other.
            const auto share = [&](const QString& name) { return row.tally.shares[name]; };
            QVERIFY(std::abs(share(u"oracle_rate_wrong"_s).share - 0.01) <
                    4 * share(u"oracle_rate_wrong"_s).standardError + 1e-3);
            QVERIFY(share(u"oracle_rate"_s).share > share(u"oracle_posterior"_s).share);
        }
    }
    void neighboursKeepTheirRateWhereScatterIsUnlike()
    {
        RecognitionScenario scenario;
        scenario.kind = ScenarioKind::Neighbours;
        scenario.squeezes = 3;
        scenario.options.siUnits = false;
        scenario.options.wrongType = 0.01;
        scenario.unlikeScatter = true;
        std::vector<EnrolmentTally> tallies;
        for (int run = 0; run < 300; ++run)
            tallies.push_back(
                runScenario(scenario, runSeed(1, scenario.name(), static_cast<std::uint64_t>(run))));
        const StudyTally tally = pooled(tallies);
        // 1.2 times the stated rate, and three standard errors, clustered by enrolment.
        QVERIFY2(tally.shares[u"wrong_type"_s].share < 0.012 + 3 * 0.0016,
                 qPrintable(QString::number(tally.shares[u"wrong_type"_s].share)));
        QVERIFY(tally.shares[u"type"_s].share > 0.45); // scatter of any shape: 0.35
        QVERIFY(tally.shares[u"unknown"_s].share < 0.02);
    }
    void squeezesOfLouderNoiseKeepTheirNames()
    {
        RecognitionScenario scenario;
        scenario.kind = ScenarioKind::NoiseMismatch;
        scenario.judged = 80;
        scenario.options.siUnits = false;
        std::vector<EnrolmentTally> tallies;
        for (int run = 0; run < 5; ++run)
            tallies.push_back(
                runNoiseMismatch(scenario, runSeed(1, scenario.name(), static_cast<std::uint64_t>(run))));
        const StudyTally tally = pooled(tallies);
        // Stated 1 % of 400 unknown, clustered by enrolment; 4 +- 3.
        QVERIFY(tally.shares[u"type"_s].count >= 385);
        QVERIFY(tally.shares[u"wrong_type"_s].count <= 1);
    }
};

GRIPSCOPE_TEST(RecognitionStudyTest)
#include "recognition_study_test.moc"
