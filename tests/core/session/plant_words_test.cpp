// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/plant_words.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace Qt::StringLiterals;

class PlantWordsTest : public QObject {
    Q_OBJECT
private slots:
    void theHeadlineTellsTheTruth()
    {
        const QDateTime now(QDate(2026, 11, 29), QTime(12, 0));
        const auto headline = [&](const PlantStatus& status) {
            return plantWords(status, now).headline.describe();
        };
        PlantStatus status;
        QCOMPARE(headline(status), u"plant: off"_s);
        QVERIFY(plantWords(status, now).well);
        status.on = true;
        QCOMPARE(headline(status), u"plant: connecting"_s);
        status.problem =
            Error{ErrorCode::StorageOpen, {u"postgresql://host/plant"_s, u"no server answers"_s}};
        QCOMPARE(headline(status), u"plant: server not reached yet"_s);
        status.lastReached = QDateTime(now.date(), QTime(10, 42)).toUTC();
        QCOMPARE(headline(status), u"plant: server not reached since 10:42"_s);
        status.waiting = 0;
        QCOMPARE(headline(status), u"plant: server not reached since 10:42"_s);
        status.waiting = 3120;
        QCOMPARE(headline(status), u"plant: 3120 results waiting, server not reached since 10:42"_s);
        status.waiting = 1;
        status.lastReached = status.lastReached.addDays(-1);
        QCOMPARE(headline(status), u"plant: 1 result waiting, server not reached since 2026-11-28 10:42"_s);
        QVERIFY(!plantWords(status, now).well);
        status.reached = true;
        QCOMPARE(headline(status), u"plant: 1 result waiting"_s);
        QCOMPARE(plantWords(status, now).problems.size(), std::size_t(1));
        status.waiting = 0;
        QCOMPARE(headline(status), u"plant: not in step"_s);
        status.problem.reset();
        QCOMPARE(headline(status), u"plant: being brought in step"_s);
        status.inStep = true;
        QCOMPARE(headline(status), u"plant: in step"_s);
        QVERIFY(plantWords(status, now).well);
        status.conflicts.resize(9);
        QVERIFY(!plantWords(status, now).well);
        QCOMPARE(plantWords(status, now).problems.size(), std::size_t(4)); // three, and where all are told
    }
};

GRIPSCOPE_TEST(PlantWordsTest)
#include "plant_words_test.moc"
