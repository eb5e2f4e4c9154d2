// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/limit_watch.h"
#include "core/session/squeeze/squeeze_job.h"
#include "core/signal/preparation/preparation_parts.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <QDateTime>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using JobState = SqueezeJob::State;

class SqueezeJobTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<ArmedConnection> m_connection;
    std::unique_ptr<SqueezeJob> m_job;
    std::chrono::steady_clock::time_point m_now;
    Recipe m_recipe;

    FakeGripper& gripper() { return m_connection->gripper(); }
    void poll()
    {
        m_connection->session.poll();
        m_job->poll();
    }
    bool finish()
    {
        return pollUntil(
            [this] { poll(); },
            [this] { return m_job->state() == JobState::Done || m_job->state() == JobState::Failed; });
    }

private slots:
    void init()
    {
        m_job.reset();
        m_connection = std::make_unique<ArmedConnection>();
        QVERIFY(m_connection->open());
        m_job = std::make_unique<SqueezeJob>(m_connection->session);
        m_now = {};
        m_job->setClock([this] { return m_now; });
        m_recipe = {};
        m_recipe.seconds = 0.25; // 500 samples
    }
    void enoughKnownEndsTheSqueezeInGoodOrder()
    {
        QVERIFY(m_job->start(m_recipe, 3));
        m_job->finish(QStringLiteral("too soon")); // nothing is squeezed yet
        QVERIFY(pollUntil([this] { poll(); }, [this] { return m_job->progress() > 0.3; }));
        m_job->finish(QStringLiteral("A after 0.1 s"));
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Done);
        QVERIFY(m_job->endedEarly());
        QVERIFY(m_connection->session.armed());
        QCOMPARE(gripper().finished, 1);
        QCOMPARE(gripper().stops.load(), 0);
        const Recording& recording = m_job->recording();
        QVERIFY(recording.size() < 400 && recording.size() > 150);
        QCOMPARE(recording.provenance.value(QStringLiteral("ended_early")), QStringLiteral("A after 0.1 s"));
        QVERIFY(m_job->start(m_recipe, 4)); // and the next is whole again
        QVERIFY(finish());
        QVERIFY(!m_job->endedEarly());
        QVERIFY(m_job->recording().size() > 500);
    }
    void whatDidNotObeyStopHasNoResult()
    {
        QVERIFY(m_job->start(m_recipe, 3));
        QVERIFY(pollUntil([this] { poll(); }, [this] { return m_job->progress() > 0.3; }));
        gripper().obeysStop = false; // it goes on to the squeeze's own end
        m_connection->session.stop();
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Failed);
        QCOMPARE(m_job->error()->describe(),
                 QStringLiteral("The gripper did not obey Stop. Switch off its power."));
    }
    void aGripperThatCannotEndEarlyGoesOnToTheEnd()
    {
        gripper().finishesOnRequest = false;
        QVERIFY(m_job->start(m_recipe, 3));
        QVERIFY(pollUntil([this] { poll(); }, [this] { return m_job->progress() > 0.3; }));
        m_job->finish(QStringLiteral("A after 0.1 s"));
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Done);
        QVERIFY(!m_job->endedEarly());
        QVERIFY(m_job->recording().size() > 500);
        QVERIFY(!m_job->recording().provenance.contains(QStringLiteral("ended_early")));
    }
    void aSqueezeThatMeasuresMoreThanTheCrushLimitIsStopped_data()
    {
        QTest::addColumn<double>("maxForce_N");
        QTest::addColumn<double>("maxTravel_m");
        QTest::addColumn<QString>("word");
        // The recipe asks for 30 N, the sensor says 36; 10 N on 9990 N/m go 1 mm.
        QTest::newRow("force") << 31.0 << 0.02 << "limit of 31 N";
        QTest::newRow("travel") << 100.0 << 0.0005 << "limit of 0.5 mm";
        QTest::newRow("neither") << 40.0 << 0.02 << QString();
    }
    void aSqueezeThatMeasuresMoreThanTheCrushLimitIsStopped()
    {
        QFETCH(double, maxForce_N);
        QFETCH(double, maxTravel_m);
        QFETCH(QString, word);
        m_recipe.maxForce_N = maxForce_N;
        m_recipe.maxTravel_m = maxTravel_m;
        gripper().forceGain = 1.2;
        QVERIFY(m_job->start(m_recipe, 3));
        QCOMPARE(gripper().admittedMaxForce_N, std::min(maxForce_N, 100.0)); // which the gripper watches, too
        QVERIFY(finish());
        QCOMPARE(m_job->state() == JobState::Done, word.isEmpty());
        if (word.isEmpty())
            return;
        QVERIFY(gripper().stops.load() > 0);
        QVERIFY2(m_job->error()->describe().contains(word), qPrintable(m_job->error()->describe()));
    }
    void aLimitThatNobodyGaveLeavesRoomForWhatIsMeasured()
    {
        QCOMPARE(limitAbove(30, 0), 33.0);   // a tenth
        QCOMPARE(limitAbove(30, 0.5), 33.0); // which is more than the noise
        QCOMPARE(limitAbove(30, 1), 35.0);   // five standard deviations are more
    }
    void aRecipeIsItsExcitationInNewtonsAtTheDevicesRate()
    {
        GripperIdentity identity;
        identity.sampleTime_s = 0.001;
        const ExcitationOptions options = excitationOptions(m_recipe, identity, 42);
        QVERIFY(options.kind == ExcitationKind::Prbs);
        QCOMPARE(options.samples, std::size_t(250));
        QCOMPARE(options.peak, m_recipe.peak_N);
        QCOMPARE(options.bias, m_recipe.bias_N);
        QCOMPARE(options.sampleTime_s, 0.001);
        QCOMPARE(options.seed, std::uint64_t(42));
        QVERIFY(options.oneSided);
    }
    void aSqueezeBecomesARecordingWithEverythingNeededToReadIt()
    {
        gripper().identity.forceLag_s = 0.0001;
        m_connection->session.poll();
        m_job->setOperator(QStringLiteral("Ada"));
        QVERIFY(m_job->start(m_recipe, 3));
        QCOMPARE(m_job->state(), JobState::Starting);
        QVERIFY(finish());
        QVERIFY(!m_job->error());
        QCOMPARE(m_job->state(), JobState::Done);
        QCOMPARE(m_job->progress(), 1.0);

        const Recording& recording = m_job->recording();
        // 20 ms at 2 kHz before and after: 40 samples each
        QCOMPARE(recording.size(), std::size_t(40 + 500 + 40));
        const auto moving = std::count_if(recording.status.begin(), recording.status.end(),
                                          [](std::uint16_t status) { return status & StatusMoving; });
        QCOMPARE(moving, 500);
        QVERIFY(recording.status[40] & StatusMoving);
        QCOMPARE(recording.sequence.size(), recording.size());
        QCOMPARE(recording.time_s.size(), recording.size());
        QVERIFY(findGaps(recording).empty());
        QCOMPARE(recording.sampleTime_s, 0.0005);
        QCOMPARE(recording.forceLag_s, 0.0001);
        QVERIFY(recording.hold == ForceHold::Zero);
        QCOMPARE(recording.forceUnit, QStringLiteral("N"));
        QCOMPARE(recording.positionUnit, QStringLiteral("m"));
        const Window all = chooseWindow(recording).window;
        QCOMPARE(all.first, std::size_t(40));
        QCOMPARE(all.count, std::size_t(500));
    }
    void whatWasMeasuredOfTheChannelsGoesIntoTheRecordingUntilAnotherGripperComes()
    {
        gripper().identity.forceLag_s = 0.0001;
        m_connection->session.poll();
        MeasuringChain chain;
        chain.forceLagUncertainty_s = 2e-6;
        m_connection->session.setMeasuringChain(0.00012, chain);
        QVERIFY(m_job->start(m_recipe, 3));
        QVERIFY(finish());
        QCOMPARE(m_job->recording().forceLag_s, 0.00012);
        QVERIFY(m_job->recording().chain == chain);

        QVERIFY(m_connection->session.connectTo(QStringLiteral("fake:")));
        m_connection->session.poll();
        QCOMPARE(m_connection->session.forceLag_s(), 0.0001);
        QVERIFY(m_connection->session.measuringChain() == MeasuringChain());
    }
    void theProvenanceSaysWhatBefellTheStream()
    {
        gripper().dropSample = [](int index) { return index == 100 || (index >= 200 && index < 205); };
        QVERIFY(m_job->start(m_recipe, 3));
        // Marked as a device marks them: the first is before the recording, the others within it.
        gripper().pending[0].badReports = 7;
        gripper().pending[150].duplicates = 2;
        gripper().pending[160].badReports = 1;
        gripper().pending[170].stall_ms = 80;
        gripper().pending[300].stall_ms = 60;
        gripper().pending[310].clockStepped = true;
        QVERIFY(finish());
        QCOMPARE(m_job->recording().provenance.value(QStringLiteral("stream")),
                 QStringLiteral("lost_samples=6 gaps=2 duplicate_reports=2 bad_reports=1 clock_steps=1 "
                                "stalls=2 longest_stall_s=0.08"));
    }
    void theProvenanceSaysWhereItComesFrom()
    {
        m_job->setOperator(QStringLiteral("Ada"));
        QVERIFY(m_job->start(m_recipe, 3));
        QVERIFY(finish());
        const QMap<QString, QString>& facts = m_job->recording().provenance;
        const QMap<QString, QString> expected{{QStringLiteral("device"), QStringLiteral("Fake gripper")},
                                              {QStringLiteral("serial"), QStringLiteral("F-1")},
                                              {QStringLiteral("address"), QStringLiteral("fake:")},
                                              {QStringLiteral("firmware"), QStringLiteral("1.2")},
                                              {QStringLiteral("operator"), QStringLiteral("Ada")},
                                              {QStringLiteral("excitation"), QStringLiteral("prbs")},
                                              {QStringLiteral("excitation_peak_N"), QStringLiteral("10")},
                                              {QStringLiteral("excitation_bias_N"), QStringLiteral("20")},
                                              {QStringLiteral("excitation_bit_s"), QStringLiteral("0.005")},
                                              {QStringLiteral("excitation_seed"), QStringLiteral("3")}};
        for (auto it = expected.cbegin(); it != expected.cend(); ++it)
            QCOMPARE(facts.value(it.key()), it.value());
        const QDateTime when =
            QDateTime::fromString(facts.value(QStringLiteral("recorded_utc")), Qt::ISODateWithMs);
        QVERIFY(when.isValid());
        QCOMPARE(when.offsetFromUtc(), 0);
        QVERIFY(std::abs(when.secsTo(QDateTime::currentDateTimeUtc())) < 3600);
    }
    void theSameSeedCommandsTheSameForce()
    {
        QVERIFY(m_job->start(m_recipe, 5));
        QVERIFY(finish());
        const std::vector<double> once = gripper().commanded_N;
        QVERIFY(m_job->start(m_recipe, 5));
        QVERIFY(finish());
        QCOMPARE(gripper().commanded_N, once);
        QVERIFY(m_job->start(m_recipe, 6));
        QVERIFY(finish());
        QVERIFY(gripper().commanded_N != once);
    }
    void lostSamplesStayLost()
    {
        gripper().dropSample = [](int index) { return index >= 100 && index < 107; };
        QVERIFY(m_job->start(m_recipe, 1));
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Done);
        QCOMPARE(findGaps(m_job->recording()), (std::vector<Gap>{{140, 7}}));
    }
    void theEndIsFoundWhenTheLastMovingSamplesAreLost()
    {
        gripper().dropSample = [](int index) { return index >= 490; };
        QVERIFY(m_job->start(m_recipe, 1));
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Done);
    }
    void aDeviceThatOnlySendsWhileItMovesIsNotWaitedFor()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        for (int i = 0; i < 500; ++i)
            gripper().push(20, 0.001, StatusArmed | StatusMoving);
        gripper().squeezeState = SqueezeState::Finished;
        for (int i = 0; i < 10; ++i)
            poll();
        QCOMPARE(m_job->state(), JobState::Squeezing); // the rest may still come
        m_now += std::chrono::milliseconds(251);
        poll();
        QCOMPARE(m_job->state(), JobState::Done);
        QCOMPARE(m_job->recording().size(), std::size_t(500));
    }
    void aLostDeviceFailsTheSqueezeWithItsReason()
    {
        gripper().lostAfterSamples = 200;
        QVERIFY(m_job->start(m_recipe, 1));
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Failed);
        QCOMPARE(m_job->error()->code, ErrorCode::DeviceLost);
    }
    void aRefusalOfTheDeviceFailsTheSqueeze()
    {
        gripper().refusesExcitation = true;
        QVERIFY(m_job->start(m_recipe, 1));
        QVERIFY(finish());
        QCOMPARE(m_job->error()->code, ErrorCode::DeviceRefused);
    }
    void whatTheGateRefusesIsNeverStarted()
    {
        m_recipe.maxForce_N = 29; // bias 20 + peak 10
        QCOMPARE(m_job->start(m_recipe, 1).error().code, ErrorCode::LimitExceeded);
        QCOMPARE(m_job->state(), JobState::Idle);
        m_connection->session.disarm();
        m_recipe.maxForce_N = 40;
        QCOMPARE(m_job->start(m_recipe, 1).error().code, ErrorCode::NotArmed);
        QCOMPARE(gripper().started, 0);
    }
    void stoppedByAPersonIsToldApartFromAFault()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        poll();
        m_connection->session.stop();
        QVERIFY(finish());
        QCOMPARE(m_job->error()->code, ErrorCode::Cancelled);
    }
    void cancellingStopsTheGripper()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        poll();
        m_job->cancel();
        QCOMPARE(m_job->state(), JobState::Failed);
        QCOMPARE(m_job->error()->code, ErrorCode::Cancelled);
        QCOMPARE(gripper().stops.load(), 1);
    }
    void destroyingARunningJobStopsTheGripper()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        poll();
        m_job.reset();
        QCOMPARE(gripper().stops.load(), 1);
        m_connection->session.poll(); // its listener is gone
    }
    void aLimitThatEndsTheSqueezeIsNamed()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        for (int i = 0; i < 10; ++i)
            gripper().push(20, 0.001, StatusArmed | StatusMoving);
        gripper().push(20, 0.02, StatusArmed | StatusTravelLimit);
        gripper().squeezeState = SqueezeState::Stopped;
        QVERIFY(finish());
        QCOMPARE(m_job->error()->code, ErrorCode::DeviceRefused);
        QVERIFY(m_job->error()->describe().contains(QStringLiteral("travel limit")));
    }
    void whatTheDeviceSaysBeforeAnythingMovedIsToldNotCancelled_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("word");
        QTest::newRow("a limit at the first moving sample")
            << int(StatusForceLimit) << QStringLiteral("the force limit was reached");
        QTest::newRow("travel") << int(StatusTravelLimit) << QStringLiteral("the travel limit was reached");
        QTest::newRow("watchdog") << int(StatusWatchdog)
                                  << QStringLiteral("no longer heard from this program");
        QTest::newRow("fault") << int(StatusFault) << QStringLiteral("it reports a fault");
    }
    void whatTheDeviceSaysBeforeAnythingMovedIsToldNotCancelled()
    {
        QFETCH(int, status);
        QFETCH(QString, word);
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        for (int i = 0; i < 40; ++i)
            gripper().push(0, 0.001, StatusArmed);
        gripper().push(0, 0.001, static_cast<std::uint16_t>(status)); // disarmed by itself
        gripper().squeezeState = SqueezeState::Stopped;
        QVERIFY(finish());
        QCOMPARE(m_job->error()->code, ErrorCode::DeviceRefused);
        QVERIFY2(m_job->error()->describe().contains(word), qPrintable(m_job->error()->describe()));
    }
    void whatItSaidBeforeItWasArmedIsOld()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        gripper().push(0, 0.001, StatusForceLimit); // of the squeeze before; Arm clears it
        for (int i = 0; i < 40; ++i)
            gripper().push(0, 0.001, StatusArmed);
        poll();
        m_connection->session.stop();
        QVERIFY(finish());
        QCOMPARE(m_job->error()->code, ErrorCode::Cancelled);
    }
    void aReasonThatTheLinkKnowsIsTold_data()
    {
        QTest::addColumn<SqueezeState>("state");
        QTest::newRow("stopped") << SqueezeState::Stopped;
        QTest::newRow("no end") << SqueezeState::Running;
    }
    void aReasonThatTheLinkKnowsIsTold()
    {
        QFETCH(SqueezeState, state);
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        poll();
        const Error reason{ErrorCode::DeviceRefused,
                           {QStringLiteral("start"), QStringLiteral("motor too hot")}};
        gripper().error = reason;
        gripper().squeezeState = state;
        m_now += std::chrono::milliseconds(2251);
        QVERIFY(finish());
        QCOMPARE(m_job->error()->describe(), reason.describe());
    }
    void reportsThatCannotBeReadAreNamedInPlaceOfTheCable()
    {
        gripper().neverStarts = true;
        gripper().counters.badReports = 3; // before
        poll();
        QVERIFY(m_job->start(m_recipe, 1));
        gripper().counters.badReports = 503;
        poll();
        m_now += std::chrono::milliseconds(2251);
        QVERIFY(finish());
        const QString told = m_job->error()->describe();
        QVERIFY2(told.contains(QStringLiteral("500 of its reports")), qPrintable(told));
        QVERIFY2(!told.contains(QStringLiteral("cable")), qPrintable(told));
    }
    void aSqueezeThatEndsFarTooEarlyIsNoSqueeze()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        for (int i = 0; i < 300; ++i)
            gripper().push(20, 0.001, StatusArmed | StatusMoving);
        for (int i = 0; i < 50; ++i)
            gripper().push(20, 0.001, StatusArmed);
        gripper().squeezeState = SqueezeState::Finished;
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Failed);
    }
    void withoutAnEndTheGripperIsStoppedTwoSecondsAfterItWasDue()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        m_now += std::chrono::milliseconds(2249);
        poll();
        QCOMPARE(m_job->state(), JobState::Squeezing);
        m_now += std::chrono::milliseconds(2);
        poll();
        QCOMPARE(m_job->state(), JobState::Failed);
        QCOMPARE(m_job->error()->code, ErrorCode::DeviceTimeout);
        QCOMPARE(gripper().stops.load(), 1);
    }
    void onlyOneSqueezeAtATime()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        QCOMPARE(m_job->start(m_recipe, 2).error().code, ErrorCode::Usage);
        QCOMPARE(m_job->listen(1).error().code, ErrorCode::Usage);
    }
    void listeningTakesWhatComesWithoutMovingAnything()
    {
        gripper().identity.commandable = false;
        QVERIFY(m_job->listen(0.1));
        for (int i = 0; i < 300; ++i)
            gripper().push(i, 0, 0);
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Done);
        QCOMPARE(m_job->recording().size(), std::size_t(200));
        QCOMPARE(gripper().started + gripper().stops.load(), 0);
    }
    void lostSamplesDoNotMakeListeningLonger()
    {
        QVERIFY(m_job->listen(0.1));
        for (int i = 0; i < 300; ++i)
            i < 150 && i >= 50 ? gripper().skip() : gripper().push(i, 0, 0);
        QVERIFY(finish());
        QCOMPARE(m_job->recording().size(), std::size_t(100));
        QCOMPARE(m_job->recording().sequence.back(), std::uint64_t(199));
    }
    void aStreamThatEndsWhileListenedToIsWhatThereWas()
    {
        QVERIFY(m_job->listen(1));
        for (int i = 0; i < 50; ++i)
            gripper().push(i, 0, 0);
        poll();
        gripper().state = LinkState::Closed;
        QVERIFY(finish());
        QCOMPARE(m_job->state(), JobState::Done);
        QCOMPARE(m_job->recording().size(), std::size_t(50));
    }
    void silenceWhileListeningTimesOut()
    {
        QVERIFY(m_job->listen(1));
        m_now += std::chrono::milliseconds(3001);
        poll();
        QCOMPARE(m_job->state(), JobState::Failed);
        QCOMPARE(m_job->error()->code, ErrorCode::DeviceTimeout);
    }
    void aDisconnectionFailsTheSqueeze()
    {
        gripper().neverStarts = true;
        QVERIFY(m_job->start(m_recipe, 1));
        m_connection->session.disconnect();
        m_job->poll();
        QCOMPARE(m_job->state(), JobState::Failed);
        QCOMPARE(m_job->error()->code, ErrorCode::DeviceLost);
    }
};

GRIPSCOPE_TEST(SqueezeJobTest)
#include "squeeze_job_test.moc"
