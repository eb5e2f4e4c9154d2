// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_facts.h"
#include "core/calibration/sensor_calibration.h"
#include "core/identification/identification.h"
#include "core/session/calibrate/calibrate_session.h"
#include "core/session/squeeze/squeeze_job.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// The force sensor of this gripper reads 3 % too high, and 0.2 N at nothing.
double readingOf(double load_N)
{
    return 0.2 + 1.03 * load_N;
}

} // namespace

class CalibrateSessionTest : public QObject {
    Q_OBJECT
    using State = CalibrateSession::State;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<LibraryService> m_library;
    std::unique_ptr<ArmedConnection> m_connection;
    std::unique_ptr<CalibrateSession> m_session;

    void poll()
    {
        m_connection->session.poll();
        m_session->poll();
    }
    bool until(State state)
    {
        return pollUntil([this] { poll(); }, [this, state] { return m_session->state() == state; });
    }
    /// The channel under that load for as long as a point takes; `drift_N` from begin to end.
    void putOn(double load_N, double drift_N = 0, std::uint16_t status = 0)
    {
        FakeGripper& g = m_connection->gripper();
        g.noise_m = 1;
        g.pending.clear();
        constexpr int samples = 400;
        for (int i = 0; i < samples; ++i)
            g.push(readingOf(load_N) + drift_N * i / samples + 0.005 * g.noise(), 1e-3, status);
    }
    bool take(double load_N, double drift_N = 0, std::uint16_t status = 0)
    {
        if (!m_session->take())
            return false;
        putOn(load_N, drift_N, status);
        return until(State::Waiting);
    }
    bool takeAll()
    {
        while (const std::optional<PlannedPoint> point = m_session->next())
            if (!take(point->load))
                return false;
        return true;
    }
    static CalibrationPlan plan()
    {
        CalibrationPlan plan;
        plan.loads = {0, 10, 20, 30};
        plan.reference = {u"Weights M1"_s, u"4711"_s, 0.002, 0};
        plan.averaging_s = 0.2;
        return plan;
    }
    CalibrationsInForce stored()
    {
        return m_library
            ->run<CalibrationsInForce>([](Library& library) { return library.calibrationsInForce(u"F-1"_s); })
            .get()
            .value();
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_library = std::make_unique<LibraryService>(m_folder->filePath(u"calibrate.db"_s));
        m_connection = std::make_unique<ArmedConnection>();
        QVERIFY(m_connection->open(false));
        m_session = std::make_unique<CalibrateSession>(m_connection->session, *m_library);
        m_session->setOperator(u"Ada"_s);
    }
    void cleanup()
    {
        m_session.reset();
        m_connection.reset();
        m_library.reset();
    }

    void pointAfterPointThenStoredAndInForce()
    {
        QVERIFY(m_session->start(plan()));
        QCOMPARE(m_session->planned().size(), std::size_t(13)); // 4 up, 3 down, 3 up, 3 down
        QVERIFY(takeAll());
        for (const TakenPoint& point : m_session->points())
            QVERIFY2(point.doubt.isEmpty(), qPrintable(point.doubt));
        QVERIFY(m_session->evaluation() && *m_session->evaluation());
        const CalibrationEvaluation& found = **m_session->evaluation();
        // 13 means of 400 samples with 0.005 N each: 0.00025 N; six of them for slope and zero.
        QVERIFY(std::abs(found.curve.readingAt(0) - 0.2) < 1.5e-3);
        QVERIFY(std::abs(found.curve.readingAt(30) - readingOf(30)) < 1.5e-3);
        QVERIFY(m_session->accept(QDate(2030, 1, 31), u"new cable"_s));
        QVERIFY(until(State::Stored));
        const CalibrationsInForce kept = stored();
        QVERIFY(kept.force && !kept.position);
        QCOMPARE(kept.force->operatorName, u"Ada"_s);
        QCOMPARE(kept.force->points.size(), std::size_t(13));
        QCOMPARE(kept.force->due, QDate(2030, 1, 31));

        // What comes now is corrected, and the device's own reading can be had.
        std::vector<Sample> seen;
        m_connection->session.addListener([&](const std::vector<Sample>& batch) { seen = batch; });
        putOn(17);
        QVERIFY(pollUntil([this] { poll(); }, [&] { return !seen.empty(); }));
        QVERIFY(std::abs(seen[0].force - 17) < 0.05);
        QVERIFY(std::abs(m_connection->session.uncorrected(SensorChannel::Force, 17) - readingOf(17)) < 2e-3);
        QCOMPARE(seen[0].position, 1e-3);
    }

    void asFoundAndTheCheckAfterwardsAreKept()
    {
        QVERIFY(m_session->start(plan()));
        QVERIFY(takeAll() && m_session->accept(QDate(2030, 1, 31), {}) && until(State::Stored));
        QCOMPARE(stored().force->foundCorrection, std::optional(u""_s)); // the channel's own scale
        QVERIFY(stored().force->checkPoints.empty());

        CalibrationPlan again = plan();
        again.runs = 1;
        again.checkAfter = true;
        again.conditions.ambient_C = 21.5;
        QVERIFY(m_session->start(again));
        QCOMPARE(m_session->planned().size(), std::size_t(13)); // 4 up, 3 down, and as a check 3 up, 3 down
        QVERIFY(takeAll());
        const int freedom = (*m_session->evaluation())->curve.degreesOfFreedom();
        QCOMPARE(freedom, 5); // of seven points: those of the check are not fitted
        QVERIFY(m_session->accept(QDate(2030, 1, 31), {}) && until(State::Stored));
        const CalibrationRecord kept = *stored().force;
        QCOMPARE(kept.points.size(), std::size_t(7));
        QCOMPARE(kept.checkPoints.size(), std::size_t(6));
        QCOMPARE(kept.conditions.ambient_C, std::optional(21.5));
        QCOMPARE(kept.certificateNumber, qint64(2));
        // The first calibration was in force: as found, its loads are right where the bare readings are 1.1 N
        // off.
        const std::optional<LoadErrors> found = errorsAsFound(kept);
        QVERIFY(found);
        QVERIFY2(found->largest < 5e-3, qPrintable(QString::number(found->largest)));
    }

    void aSecondCalibrationIsOfTheDeviceNotOfTheFirst()
    {
        QVERIFY(m_session->start(plan()));
        QVERIFY(takeAll() && m_session->accept(QDate(2030, 1, 31), {}) && until(State::Stored));
        QVERIFY(m_session->start(plan()));
        QVERIFY(takeAll());
        QVERIFY(std::abs((*m_session->evaluation())->curve.readingAt(30) - readingOf(30)) < 3e-3);
    }

    void whatMovesOrIsAtItsEndIsNotTaken()
    {
        QVERIFY(m_session->start(plan()));
        QVERIFY(take(0, 0.3));
        QVERIFY(m_session->points().empty());
        QVERIFY(m_session->error()->describe().contains(u"moves"_s));
        QVERIFY(take(0, 0, StatusForceSaturated));
        QVERIFY(m_session->points().empty());
        QVERIFY(m_session->error()->describe().contains(u"at its end"_s));
        QVERIFY(take(0));
        QCOMPARE(m_session->points().size(), std::size_t(1));
        QVERIFY(!m_session->error());
    }

    void aForgottenLoadIsDoubtedAndCanBeTakenAgain()
    {
        QVERIFY(m_session->start(plan()));
        QVERIFY(take(0) && take(0)); // 10 N was asked for
        QVERIFY(m_session->points()[1].doubt.contains(u"put on"_s));
        m_session->undo();
        QVERIFY(take(10));
        QVERIFY(m_session->points()[1].doubt.isEmpty());
        QVERIFY(take(5)); // 20 N was asked for
        QVERIFY(m_session->points()[2].doubt.contains(u"other way"_s));
    }

    void nothingIsCalibratedWhileArmed()
    {
        QVERIFY(m_connection->session.arm(u"Ada"_s));
        m_connection->session.poll();
        QVERIFY(!m_session->start(plan()));
        m_connection->session.disarm();
        m_connection->session.poll();
        QVERIFY(m_session->start(plan()));
        QVERIFY(m_session->take());
        QVERIFY(m_connection->session.arm(u"Ada"_s));
        m_connection->session.poll();
        QVERIFY(until(State::Waiting));
        QVERIFY(m_session->points().empty() && m_session->error());
    }

    void anIncompleteOneIsNotStored()
    {
        QVERIFY(m_session->start(plan()));
        QVERIFY(take(0) && take(10) && take(20));
        QVERIFY(m_session->evaluation()); // it can be looked at
        QVERIFY(!m_session->accept(QDate(2030, 1, 31), {}));
        QVERIFY(!stored().force);
    }

    void plansThatMakeNoSenseAreRefused_data()
    {
        QTest::addColumn<std::vector<double>>("loads");
        QTest::addColumn<int>("degree");
        QTest::addColumn<int>("runs");
        QTest::newRow("one load") << std::vector<double>{1} << 1 << 2;
        QTest::newRow("twice the same") << std::vector<double>{0, 1, 1} << 1 << 2;
        QTest::newRow("falling") << std::vector<double>{2, 1, 0} << 1 << 2;
        QTest::newRow("too high a degree") << std::vector<double>{0, 1, 2} << 3 << 2;
        QTest::newRow("no run") << std::vector<double>{0, 1, 2} << 1 << 0;
        QTest::newRow("not a number") << std::vector<double>{0, std::nan(""), 2} << 1 << 2;
    }
    void plansThatMakeNoSenseAreRefused()
    {
        QFETCH(std::vector<double>, loads);
        QFETCH(int, degree);
        QFETCH(int, runs);
        CalibrationPlan bad = plan();
        bad.loads = loads;
        bad.degree = degree;
        bad.runs = runs;
        QVERIFY(!m_session->start(bad));
        QVERIFY(m_session->state() == State::Idle);
    }

    void anOverdueCalibrationMakesTheMeasurementSuspect_data()
    {
        QTest::addColumn<int>("days");
        QTest::newRow("overdue") << -3;
        QTest::newRow("holds") << 200;
    }
    void anOverdueCalibrationMakesTheMeasurementSuspect()
    {
        QFETCH(int, days);
        CalibrationRecord record;
        record.gripperSerial = u"F-1"_s;
        record.unit = u"N"_s;
        record.reference.name = u"Weights"_s;
        record.reference.relativeUncertainty = 0.004;
        for (const double load : {0.0, 10.0, 20.0, 40.0, 0.0})
            record.points.push_back({load, load});
        record.due = QDate::currentDate().addDays(days);
        record.takenUtc = QDateTime::currentDateTimeUtc();
        m_connection->session.setCalibrations({record, {}, {}});
        QVERIFY(m_connection->session.arm(u"Ada"_s));
        m_connection->session.poll();
        SqueezeJob job(m_connection->session);
        m_connection->gripper().noise_m = 5e-6;
        QVERIFY(job.start(Recipe(), 1));
        QVERIFY(pollUntil(
            [&] {
                m_connection->session.poll();
                job.poll();
            },
            [&] {
                return job.state() == SqueezeJob::State::Done || job.state() == SqueezeJob::State::Failed;
            }));
        QVERIFY(job.state() == SqueezeJob::State::Done);
        const auto facts = calibrationFacts(job.recording().provenance);
        QCOMPARE(facts.size(), std::size_t(1));
        QCOMPARE(facts[0].daysLeft, qint64(days));
        QVERIFY(facts[0].words.describe().contains(u"Weights"_s));
        QVERIFY(std::abs(job.recording().chain.forceScaleUncertainty - 0.004) < 1e-6);
        const Identification found = identify(job.recording());
        const auto& checks = found.validity.checks;
        const auto check = std::find_if(checks.begin(), checks.end(),
                                        [](const ValidityCheck& one) { return one.id == u"calibration"_s; });
        QVERIFY(check != checks.end());
        QCOMPARE(check->ok, days >= 0);
        QCOMPARE(found.validity.verdict == ValidityVerdict::Suspect, days < 0);
    }

    void aRecordingThatIsPlayedBackIsNotCorrectedTwice()
    {
        CalibrationRecord record;
        record.unit = u"N"_s;
        for (const double load : {0.0, 10.0, 20.0})
            record.points.push_back({load, 2 * load});
        m_connection->gripper().identity.corrected = true;
        m_connection->session.poll();
        m_connection->session.setCalibrations({record, {}, {}});
        QCOMPARE(m_connection->session.uncorrected(SensorChannel::Force, 5), 5.0);
    }

    void whatTheLoadCellShowsCounts()
    {
        CalibrationPlan read = plan();
        read.loadsAreRead = true;
        QVERIFY(m_session->start(read));
        QVERIFY(!m_session->take(std::nan("")));
        int step = 0;
        while (const std::optional<PlannedPoint> point = m_session->next()) {
            const double shown =
                point->load + 0.37 * (step++ % 3); // by hand, so never quite what was planned
            QVERIFY(m_session->take(shown));
            putOn(shown);
            QVERIFY(until(State::Waiting));
        }
        const CalibrationEvaluation& found = **m_session->evaluation();
        QVERIFY(std::abs(found.curve.readingAt(30) - readingOf(30)) < 1.5e-3); // as with weights
        QCOMPARE(m_session->points()[1].planned.load, 10.37);
    }

    void aCalibrationInAnotherUnitIsNotApplied()
    {
        CalibrationRecord record;
        record.unit = u"mN"_s;
        for (const double load : {0.0, 10.0, 20.0})
            record.points.push_back({load, 2 * load});
        m_connection->session.setCalibrations({record, {}, {}});
        QVERIFY(m_connection->session.calibration().record(SensorChannel::Force) == nullptr);
        QVERIFY(m_connection->session.calibration().unusable().contains(u"mN"_s));
    }
};

GRIPSCOPE_TEST(CalibrateSessionTest)
#include "calibrate_session_test.moc"
