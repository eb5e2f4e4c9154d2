// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

/// What a technician does beside squeezing: voids the last one, begins a shift, scans part numbers.
class InspectShiftTest : public QObject {
    Q_OBJECT
private:
    using Run = InspectionRun;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

    static void inspect(Run& run, const Recording& recording)
    {
        QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("file.csv")));
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.lastError());
    }
    static bool settled(Run& run)
    {
        return run.until([&] { return !run.inspection.changingBatch(); });
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("test.db"));
        enrolTypes(m_file, {{QStringLiteral("A"), canA}}, 5);
    }
    void theLastSqueezeIsVoidedAndTheBatchHasOneLess()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        run.inspection.setExpectedType(QStringLiteral("A"));
        run.inspection.voidLast(QStringLiteral("why")); // there is none, and nothing happens
        QVERIFY(!run.inspection.changingBatch());
        run.inspection.beginBatch({QStringLiteral("4711"), 2, QStringLiteral("A"), {}});
        QVERIFY(settled(run));
        inspect(run, squeezeOf(canA, 77));
        inspect(run, squeezeOf(canA, 78));
        QVERIFY(run.inspection.batch()->whole());
        QVERIFY(!run.inspection.result()->voided);
        run.inspection.voidLast(QStringLiteral("squeezed twice"));
        QVERIFY(settled(run));
        QVERIFY(!run.inspection.lastError());
        QVERIFY(run.inspection.result()->voided);
        QCOMPARE(run.inspection.counts().total, qint64(1));
        QCOMPARE(run.inspection.counts().voided, qint64(1));
        QCOMPARE(run.inspection.batch()->counts.asExpected, qint64(1)); // though it has ended
        QVERIFY(!run.inspection.batch()->whole());
    }
    void aShiftCountsFromItsBeginningOn()
    {
        {
            Run run(m_file);
            QVERIFY(run.ready());
            inspect(run, squeezeOf(canA, 77));
            QCOMPARE(run.inspection.shiftCounts().total, qint64(1)); // all, while no shift was begun
            run.inspection.setShiftStart(run.inspection.result()->number);
            QVERIFY(settled(run));
            QCOMPARE(run.inspection.shiftCounts().total, qint64(0));
            inspect(run, squeezeOf(canA, 78));
            QCOMPARE(run.inspection.shiftCounts().total, qint64(1));
            QCOMPARE(run.inspection.counts().total, qint64(2));
        }
        Run run(m_file); // where it began is handed over after a start
        run.inspection.setShiftStart(1);
        QVERIFY(run.ready());
        QVERIFY(settled(run));
        QCOMPARE(run.inspection.shiftCounts().total, qint64(1));
    }
    void aPartNumberGoesWithOneSqueeze()
    {
        Run run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        run.inspection.setPartNumber(QStringLiteral("SN 7"));
        QVERIFY(run.inspection.squeeze());
        QVERIFY(run.inspection.partNumber().isEmpty());
        run.inspection.cancel(); // the part has still to be squeezed
        QCOMPARE(run.inspection.partNumber(), QStringLiteral("SN 7"));
        inspect(run, squeezeOf(canA, 77));
        QCOMPARE(run.inspection.result()->partNumber, QStringLiteral("SN 7"));
        inspect(run, squeezeOf(canA, 78));
        QVERIFY(run.inspection.result()->partNumber.isEmpty());
        const auto stored =
            run.library.run<std::vector<InspectionRecord>>([](Library& l) { return l.inspections({}); })
                .get();
        QCOMPARE(stored->at(1).partNumber, QStringLiteral("SN 7"));
        QVERIFY(stored->at(0).partNumber.isEmpty());
    }
    void invalidOnesInARowAreCounted()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        inspect(run, constantForce());
        inspect(run, constantForce());
        QCOMPARE(run.inspection.result()->invalidInARow, 2);
        inspect(run, squeezeOf(canA, 77));
        QCOMPARE(run.inspection.result()->invalidInARow, 0);
        inspect(run, constantForce());
        QCOMPARE(run.inspection.result()->invalidInARow, 1);
    }
};

GRIPSCOPE_TEST(InspectShiftTest)
#include "inspect_shift_test.moc"
