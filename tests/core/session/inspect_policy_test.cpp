// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/history.h"
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

class InspectPolicyTest : public QObject {
    Q_OBJECT
private:
    using Run = InspectionRun;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

private slots:
    void initTestCase()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        enrolTypes(m_folder->filePath(QStringLiteral("enrolled.db")),
                   {{QStringLiteral("A"), canA}, {QStringLiteral("C"), canC}}, 5);
    }
    void init()
    {
        static int run = 0;
        m_file = m_folder->filePath(QStringLiteral("run-%1.db").arg(++run));
        QVERIFY(QFile::copy(m_folder->filePath(QStringLiteral("enrolled.db")), m_file));
    }
    void whatThePolicyRefusesIsKeptAndNotJudged_data()
    {
        QTest::addColumn<JudgingPolicy>("policy");
        QTest::addColumn<int>("daysLeft");
        QTest::addColumn<bool>("losing");
        QTest::addColumn<QString>("reason");
        const JudgingPolicy strict{true, 0.01, false};
        QTest::newRow("clean") << strict << 1 << false << QString();
        QTest::newRow("overdue") << strict << -12 << false << QStringLiteral("overdue by 12 days, and");
        QTest::newRow("overdue, allowed") << JudgingPolicy{} << -12 << false << QString();
        QTest::newRow("lost") << strict << 1 << true << QStringLiteral("of the samples were lost, and");
        QTest::newRow("lost, allowed") << JudgingPolicy{} << 1 << true << QString();
        QTest::newRow("nobody") << JudgingPolicy{false, 0, true} << 1 << false
                                << QStringLiteral("nobody is signed in");
    }
    void whatThePolicyRefusesIsKeptAndNotJudged()
    {
        QFETCH(JudgingPolicy, policy);
        QFETCH(int, daysLeft);
        QFETCH(bool, losing);
        QFETCH(QString, reason);
        Run run(m_file);
        QVERIFY(run.ready());
        run.inspection.setPolicy(policy);
        Recording recording = squeezeOf(canA, 77);
        recording.provenance[QStringLiteral("force_calibration_days_left")] = QString::number(daysLeft);
        for (auto i = std::ptrdiff_t(recording.size()) - 20; losing && i > 50; i -= 50)
            for (std::vector<double>* channel : {&recording.time_s, &recording.force, &recording.position})
                channel->erase(channel->begin() + i); // 2 %
        QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("file.csv")));
        run.inspection.setPolicy({}); // that of its beginning counts
        QVERIFY(run.ready());
        const InspectSession::Result& result = *run.inspection.result();
        const bool refused = !reason.isEmpty();
        QCOMPARE(result.refused, refused);
        QCOMPARE(result.outcome == InspectionOutcome::NotValid, refused);
        const auto stored =
            run.library.run<std::vector<InspectionRecord>>([](Library& l) { return l.inspections({}); })
                .get();
        QCOMPARE(stored->size(), std::size_t(1)); // it is not lost
        const InspectionRecord& kept = stored->at(0);
        QCOMPARE(kept.verdict == VerdictKind::Invalid, refused);
        QVERIFY2(kept.reason.describe().contains(reason), qPrintable(kept.reason.describe()));
        QCOMPARE(kept.type, refused ? QString() : QStringLiteral("A"));
    }
};

GRIPSCOPE_TEST(InspectPolicyTest)
#include "inspect_policy_test.moc"
