// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_due.h"
#include "core/session/quality/study_options.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

StudyRecord finishedStudy(const QString& kind, const QString& serial, const QDate& ended, int months)
{
    StudyOptions options;
    options.repeatAfterMonths = months;
    StudyRecord record;
    record.id = kind + ended.toString(Qt::ISODate);
    record.study.kind = kind;
    record.study.options = toJson(options);
    record.study.gripperSerial = serial;
    record.state = StudyState::Finished;
    record.begun = QDateTime(ended, QTime(11, 0)).toUTC();
    record.ended = QDateTime(ended, QTime(12, 0)).toUTC();
    return record;
}

} // namespace

/// When a study is to be made again.
class DueAgainTest : public QObject {
    Q_OBJECT
private slots:
    void aStudyHoldsSoManyMonths_data()
    {
        QTest::addColumn<QDate>("ended");
        QTest::addColumn<int>("months");
        QTest::addColumn<QDate>("due"); // invalid: never
        QTest::newRow("a year") << QDate(2026, 3, 1) << 12 << QDate(2027, 3, 1);
        QTest::newRow("to the end of a short month") << QDate(2026, 8, 31) << 6 << QDate(2027, 2, 28);
        QTest::newRow("never again") << QDate(2026, 3, 1) << 0 << QDate();
    }
    void aStudyHoldsSoManyMonths()
    {
        QFETCH(QDate, ended);
        QFETCH(int, months);
        QFETCH(QDate, due);
        StudyRecord study = finishedStudy(u"gauge"_s, u"F-1"_s, ended, months);
        QCOMPARE(studyHoldsUntil(study).value_or(QDate()), due);
        study.state = StudyState::Abandoned; // has no result
        QVERIFY(!studyHoldsUntil(study));
    }
    void studiesOfBeforeHoldAYear()
    {
        StudyRecord study = finishedStudy(u"gauge"_s, u"F-1"_s, QDate(2026, 3, 1), 3);
        study.study.options = QJsonObject();
        QCOMPARE(studyHoldsUntil(study), std::optional(QDate(2027, 3, 1)));
        study.study.options = QJsonObject{{u"repeat_after_months"_s, -4}}; // makes no sense
        QCOMPARE(studyHoldsUntil(study), std::optional(QDate(2027, 3, 1)));
    }
    void theNewestOfEachKindCounts()
    {
        const std::vector<StudyRecord> studies{
            finishedStudy(u"gauge"_s, u"F-2"_s, QDate(2026, 9, 1), 12),
            finishedStudy(u"gauge"_s, u"F-1"_s, QDate(2026, 6, 1), 6),
            finishedStudy(u"gauge"_s, u"F-1"_s, QDate(2026, 1, 1), 24),
            finishedStudy(u"attributes"_s, u""_s, QDate(2026, 1, 1), 12),
        };
        const std::vector<StudyStanding> own = studyStandings(studies, u"F-1"_s);
        QCOMPARE(own.size(), std::size_t(4));
        QVERIFY(own[0].kind == StudyKind::TypeOne && !own[0].last);
        QVERIFY(own[0].status(QDate(2026, 7, 1)) == StudyStatus::Missing);
        QVERIFY(own[1].due == QDate(2026, 12, 1));
        QVERIFY(own[1].status(QDate(2026, 7, 1)) == StudyStatus::Valid);
        QVERIFY(own[1].status(QDate(2026, 11, 20)) == StudyStatus::DueSoon);
        QVERIFY(own[1].status(QDate(2026, 12, 1)) == StudyStatus::DueSoon); // the last day it holds
        QVERIFY(own[1].status(QDate(2026, 12, 2)) == StudyStatus::Overdue);
        QVERIFY(own[3].last.has_value());                                 // people judge without a gripper
        QVERIFY(studyStandings(studies, {})[1].due == QDate(2027, 9, 1)); // of whichever gripper
        const StudyStanding once =
            studyStandings({finishedStudy(u"type1"_s, {}, QDate(2020, 1, 1), 0)}, {})[0];
        QVERIFY(once.status(QDate(2026, 7, 1)) == StudyStatus::NotAsked);
    }
};
GRIPSCOPE_TEST(DueAgainTest)
#include "due_again_test.moc"
