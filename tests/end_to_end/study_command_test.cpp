// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <algorithm>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class StudyCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

private slots:
    void efficiencyIsOneDocumentWithARowASettingAndPooled()
    {
        const ProgramRun run = m_work.cli({u"study"_s, u"efficiency"_s, u"--runs"_s, u"20"_s, u"--settings"_s,
                                           u"200,95"_s, u"--estimators"_s, u"oe,arx"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(run.err.contains("100 %"));
        const QJsonObject document = run.json();
        const QJsonArray settings = document[u"settings"].toArray();
        QCOMPARE(settings.size(), 4 * 2 * 2);
        const QJsonObject first = settings[0].toObject();
        QCOMPARE(first[u"setting"].toString(), u"A-prbs-95-200"_s);
        QCOMPARE(first[u"estimator"].toString(), u"oe"_s);
        QCOMPARE(first[u"used"].toInt(), 20);
        QCOMPARE(first[u"excitation"][u"bit_s"].toDouble(), 0.5);
        QVERIFY(first[u"parameters"][u"k"][u"ratio"].toDouble() > 0.5);
        const QJsonObject multisine = settings[2].toObject();
        QCOMPARE(multisine[u"excitation"][u"harmonics"].toArray(), (QJsonArray{1, 2, 3, 4}));
        QCOMPARE(document[u"pooled"].toArray().size(), 2);
        // What the paper's estimator loses is no matter of luck: its error is many times the bound.
        QVERIFY(document[u"pooled"][0][u"ratio"].toDouble() < 1.5);
        QVERIFY(document[u"pooled"][1][u"ratio"].toDouble() > 5);
    }
    void theTableSaysTheSameInText()
    {
        const ProgramRun run = m_work.cli(
            {u"study"_s, u"efficiency"_s, u"--runs"_s, u"5"_s, u"--settings"_s, u"A-prbs-90-200"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(run.out.contains("A-prbs-90-200"));
        QVERIFY(run.out.contains("of 5 runs failed"));
    }
    void modelsHaveRowsOfTheirOwn()
    {
        const ProgramRun run = m_work.cli(
            {u"study"_s, u"efficiency"_s, u"--models"_s, u"oe,friction"_s, u"--runs"_s, u"3"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonArray rows = run.json()[u"rows"].toArray();
        QCOMPARE(rows.size(), 6);
        QVERIFY(rows[0][u"parameters"][u"k"][u"ratio"].isDouble());
        QVERIFY(rows[0][u"friction_limit_percent"].isNull());
        QVERIFY(rows[1][u"near_zero"].toBool() && !rows[5][u"near_zero"].toBool());
        QVERIFY(rows[5][u"parameters"][u"Fc"][u"coverage_percent"].isDouble());
        const ProgramRun text =
            m_work.cli({u"study"_s, u"efficiency"_s, u"--models"_s, u"oe"_s, u"--runs"_s, u"3"_s});
        QVERIFY(text.out.contains("error over bound"));
        for (const QStringList& wrong : {QStringList{u"--models"_s, u"jelly"_s},
                                         QStringList{u"--models"_s, u"oe"_s, u"--settings"_s, u"A"_s}})
            QCOMPARE(m_work.cli(QStringList{u"study"_s, u"efficiency"_s} + wrong).exit, 2);
    }
    void recognitionIsOneDocumentWithStatedAndFoundRates()
    {
        const ProgramRun run = m_work.cli({u"study"_s, u"recognition"_s, u"--runs"_s, u"10"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        const QJsonArray rows = document[u"rows"].toArray();
        QVERIFY(rows.size() > 30);
        QCOMPARE(rows[0][u"row"].toString(), u"known_parts-3-0.01"_s);
        QCOMPARE(rows[0][u"enrolments"].toInt(), 10);
        QCOMPARE(rows[0][u"limits"][0][u"least"].toDouble(), 0.8);
        QVERIFY(rows[0][u"shares"][u"unknown"][u"standard_error"].isDouble());
        const auto mismatch = std::find_if(rows.begin(), rows.end(), [](const QJsonValue& row) {
            return row[u"scenario"].toString() == u"noise_mismatch"_s;
        });
        QVERIFY(mismatch != rows.end());
        QCOMPARE((*mismatch)[u"cases"].toInt(), 200);
        QVERIFY((*mismatch)[u"shares"][u"type"][u"share"].toDouble() > 0.9);
        QCOMPARE(rows.last()[u"space"].toString(), u"m+b+k+k1/k+tau+Fc"_s);
        QCOMPARE(document[u"paper"][u"leave_one_out_correct"].toInt(), 40);
    }
    void recognitionInTextSaysWhatIsMet()
    {
        const ProgramRun run = m_work.cli({u"study"_s, u"recognition"_s, u"--runs"_s, u"2"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(run.out.contains("40 of 40 right"));
        QVERIFY(run.out.contains("met"));
    }
    void earlyIsOneDocumentWithARowASetting()
    {
        const ProgramRun run =
            m_work.cli({u"study"_s, u"early"_s, u"--runs"_s, u"6"_s, u"--seed"_s, u"2"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QCOMPARE(document[u"stated_error"].toDouble(), 0.01);
        const QJsonArray settings = document[u"settings"].toArray();
        QCOMPARE(settings.size(), 8);
        for (const QJsonValue& row : settings) {
            QCOMPARE(row[u"decided"].toInt() + row[u"undecided"].toInt(), 6);
            QVERIFY(row[u"mean_samples"].toDouble() >= 10 && row[u"mean_samples"].toDouble() <= 400);
        }
        QCOMPARE(settings[0][u"setting"].toString(), u"rest-90-white"_s);
    }
};

GRIPSCOPE_TEST(StudyCommandTest)
#include "study_command_test.moc"
