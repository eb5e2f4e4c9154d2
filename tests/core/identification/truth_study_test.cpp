// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/study_json.h"
#include "core/research/truth_study.h"
#include "tests/support/test_registry.h"

#include <QSet>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

TruthStudyOptions few()
{
    TruthStudyOptions options;
    options.settings = {truthSettings()[0], truthSettings()[3]};
    options.runs = 3;
    options.seed = 7;
    return options;
}

} // namespace

class TruthStudyTest : public QObject {
    Q_OBJECT
private slots:
    void theSameSeedGivesTheSameOnAnyThreads()
    {
        TruthStudyOptions options = few();
        options.threads = 1;
        const QJsonObject one = toJson(studyTruth(options), options);
        options.threads = 3;
        QCOMPARE(toJson(studyTruth(options), options), one);
        options.seed = 8;
        QVERIFY(toJson(studyTruth(options), options) != one);
    }
    void allRunsAreCounted()
    {
        const TruthStudy study = studyTruth(few());
        QCOMPARE(study.rows.size(), 2U);
        int valid = 0;
        for (const TruthRow& row : study.rows) {
            QCOMPARE(row.valid + row.suspect + row.invalid, row.runs);
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY(row.covered[i] <= row.valid - row.widened);
                QVERIFY(row.coveredWidened[i] <= row.widened);
            }
            valid += row.valid;
        }
        QCOMPARE(study.valid, valid);
        QCOMPARE(study.runs, 6);
        QCOMPARE(study.lies, 0);
    }
    void settingsHaveNamesOfTheirOwn()
    {
        QSet<QString> names;
        for (const TruthSetting& setting : truthSettings())
            names.insert(setting.name);
        QCOMPARE(std::size_t(names.size()), truthSettings().size());
        QVERIFY(names.size() >= 40);
    }
};

GRIPSCOPE_TEST(TruthStudyTest)
#include "truth_study_test.moc"
