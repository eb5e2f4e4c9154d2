// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/line_session.h"
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace std::chrono_literals;

namespace {

/// Jobs of a PLC on a fake gripper with a library of their own.
struct LineRun : InspectionRun {
    explicit LineRun(const QString& file) : InspectionRun(file)
    {
        line.setTypes({QStringLiteral("A"), QStringLiteral("C")});
    }
    bool lineUntil(const std::function<bool()>& done)
    {
        return pollUntil(
            [this] {
                connection.session.poll();
                inspection.poll();
                line.poll(now);
            },
            done);
    }
    bool lineReady()
    {
        return lineUntil(
            [this] { return inspection.state() == InspectSession::State::Ready && !inspection.storing(); });
    }
    JobAnswer ask(std::uint16_t trigger, std::uint32_t token, std::uint16_t type)
    {
        return desk->with([&](JobDesk& d) {
            d.beat(++beat, now);
            return d.startSingleJob({trigger, type, token}, now);
        });
    }
    JobDesk::View view()
    {
        return desk->with([this](JobDesk& d) { return d.view(now); });
    }

    JobDesk::TimePoint now{1h};
    std::uint16_t beat = 0;
    std::shared_ptr<SharedJobDesk> desk = std::make_shared<SharedJobDesk>(1);
    LineSession line{connection.session, inspection, desk};
};

} // namespace

class LineSessionTest : public QObject {
    Q_OBJECT
private:
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
    void aJobIsInspectedAsTheTypeItNames_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("evaluation");
        QTest::newRow("as expected") << 1 << int(ResultEvaluation::Ok);
        QTest::newRow("another") << 2 << int(ResultEvaluation::NotOk);
        QTest::newRow("none named") << 0 << int(ResultEvaluation::Ok);
    }
    void aJobIsInspectedAsTheTypeItNames()
    {
        QFETCH(int, type);
        QFETCH(int, evaluation);
        LineRun run(m_file);
        run.connection.gripper().object = canA;
        QVERIFY(run.connection.open());
        QVERIFY(run.lineReady());
        run.line.poll(run.now);
        QVERIFY(run.view().state == LineState::Ready);
        QVERIFY(run.ask(1, 4711, static_cast<std::uint16_t>(type)) == JobAnswer::Taken);
        QVERIFY(run.lineUntil([&] { return run.view().unread; }));
        const LineResult result = *run.view().result;
        QVERIFY(result.state == ResultState::Completed);
        QCOMPARE(int(result.evaluation), evaluation);
        QCOMPARE(result.job.partToken, 4711U);
        QCOMPARE(result.typeFound, std::uint16_t(1));
        QVERIFY(!result.partial && !result.simulated);
        QVERIFY(std::abs(result.quantities[2]->value / canA.k - 1) < 0.05);
        QVERIFY(result.quantities[2]->standardUncertainty.value_or(0) > 0);
        QVERIFY(run.inspection.expectedType().isEmpty()); // as a person left it
        QVERIFY(run.lineReady());
        const auto stored =
            run.library.run<std::vector<InspectionRecord>>([](Library& l) { return l.inspections({}); })
                .get();
        QCOMPARE(stored->size(), std::size_t(1));
        QCOMPARE(stored->front().partNumber, QStringLiteral("4711"));
    }
    void anUnarmedGripperRefusesAndSaysSo()
    {
        LineRun run(m_file);
        QVERIFY(run.connection.open(false));
        QVERIFY(run.lineReady());
        run.line.poll(run.now);
        QVERIFY(run.view().state == LineState::Initialized);
        QVERIFY(run.ask(1, 5, 1) == JobAnswer::NotArmed);
        for (int i = 0; i < 20; ++i)
            QVERIFY(run.lineReady());
        run.line.poll(run.now);
        QCOMPARE(run.connection.gripper().started, 0);
        QCOMPARE(run.connection.gripper().armRequests, 0); // nothing arms by a wire
        const QStringList news = described(run.line.takeNews());
        QCOMPARE(news.size(), 1);
        QVERIFY2(news[0].contains(QStringLiteral("not armed")), qPrintable(news[0]));
        QCOMPARE(run.view().refused, 1U);
    }
    void aLostHeartbeatStopsAndDisarms()
    {
        LineRun run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.lineReady());
        run.desk->with([&](JobDesk& desk) { desk.beat(++run.beat, run.now); });
        run.line.poll(run.now);
        run.now += 3s;
        QVERIFY(run.lineUntil([&] { return !run.connection.session.armed(); }));
        run.line.poll(run.now);
        QVERIFY(run.connection.gripper().stops > 0);
        QVERIFY(run.view().state == LineState::Halted);
        QVERIFY(described(run.line.takeNews()).join(u' ').contains(QStringLiteral("disarmed")));
        QVERIFY(run.ask(1, 5, 1) == JobAnswer::NotReady); // it is back, and a person has to arm
    }
    void aSqueezeThatIsStoppedHasAResultThatDecidesNothing()
    {
        LineRun run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.lineReady());
        run.connection.gripper().neverStarts = true;
        run.inspection.setPartNumber(QStringLiteral("by hand"));
        run.line.poll(run.now);
        QVERIFY(run.ask(1, 8, 1) == JobAnswer::Taken);
        QVERIFY(run.lineUntil([&] { return run.inspection.state() == InspectSession::State::Squeezing; }));
        QVERIFY(run.ask(2, 9, 1) == JobAnswer::Busy);
        run.inspection.cancel(); // as Stop does
        QVERIFY(run.lineUntil([&] { return run.view().unread; }));
        const LineResult result = *run.view().result;
        QVERIFY(result.state == ResultState::Aborted);
        QVERIFY(result.evaluation == ResultEvaluation::NotDecidable);
        QVERIFY(result.partial);
        QCOMPARE(result.job.partToken, 8U);
        QCOMPARE(run.inspection.partNumber(), QStringLiteral("by hand")); // not the PLC's
    }
    void outcomesAreEvaluatedWithNothingHeldAgainstWhatWasNotMeasured()
    {
        QVERIFY(evaluationOf(ResultReason::AsExpected) == ResultEvaluation::Ok);
        for (const ResultReason reason :
             {ResultReason::OtherType, ResultReason::Unknown, ResultReason::DoesNotConform})
            QVERIFY(evaluationOf(reason) == ResultEvaluation::NotOk);
        for (const ResultReason reason :
             {ResultReason::Inconclusive, ResultReason::NotValid, ResultReason::NotMeasured})
            QVERIFY(evaluationOf(reason) == ResultEvaluation::NotDecidable);
    }
};

GRIPSCOPE_TEST(LineSessionTest)
#include "line_session_test.moc"
