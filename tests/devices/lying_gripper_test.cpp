// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/lying_gripper.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

// Grippers that are not what they say, in virtual time: what is sent to them, when, and what a person is
// told.

namespace {

const QString disobeyed = u"did not obey Stop. Switch off its power"_s;

QString name(ReportId id)
{
    switch (id) {
    case ReportId::Arm:
        return u"Arm"_s;
    case ReportId::Disarm:
        return u"Disarm"_s;
    case ReportId::Stop:
        return u"Stop"_s;
    case ReportId::Heartbeat:
        return u"Heartbeat"_s;
    default:
        return u"0x%1"_s.arg(int(id), 0, 16);
    }
}

QString inWords(const std::vector<LyingGripper::Sent>& sent)
{
    QStringList out;
    for (const LyingGripper::Sent& one : sent)
        out << u"%1 ms %2"_s.arg(one.ms).arg(name(one.id));
    return out.join(u", ");
}

/// Row of the table that this test prints.
void tell(const char* row, const LyingGripper& gripper, std::int64_t from_ms,
          const std::optional<Error>& told)
{
    qInfo("%-28s | %s | %s", row, qPrintable(inWords(gripper.sentSince(from_ms))),
          told ? qPrintable(told->describe()) : "-");
}

} // namespace

class LyingGripperTest : public QObject {
    Q_OBJECT

    /// From `from_ms` on exactly three Stops, 20 ms apart, and silence for the watchdog's time and 50 ms.
    static void threeStopsThenSilence(const LyingGripper& gripper, std::int64_t from_ms)
    {
        using Sent = LyingGripper::Sent;
        const std::vector<Sent> sent = gripper.sentSince(from_ms);
        QVERIFY2(sent.size() >= 3, qPrintable(inWords(sent)));
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY2(sent[i].id == ReportId::Stop, qPrintable(inWords(sent)));
            QCOMPARE(sent[i].ms, sent[0].ms + std::int64_t(20 * i));
        }
        const std::int64_t silentUntil = sent[2].ms + 100 + 50;
        QVERIFY2(gripper.ms >= from_ms + silentUntil, "the test did not wait for the end of the silence");
        for (std::size_t i = 3; i < sent.size(); ++i)
            QVERIFY2(sent[i].ms >= silentUntil, qPrintable(inWords(sent)));
    }
    static bool armAndSqueeze(LyingGripper& gripper)
    {
        gripper.run(20);
        if (!gripper.arm())
            return false;
        gripper.squeeze();
        const bool runs = gripper.runUntil([&] { return !samplesMoving(gripper.samples).empty(); }, 1000);
        if (!runs)
            qWarning("state %d; %s", int(gripper.control.squeeze().state),
                     qPrintable(whyNot(gripper.control.error())));
        return runs;
    }

private slots:
    void anHonestGripperIsProvedOnceArmedSqueezedAndObeys()
    {
        LyingGripper gripper({});
        gripper.run(20);
        const std::int64_t asked = gripper.ms;
        QVERIFY(gripper.arm());
        // Armed, left alone until its watchdog tripped, armed again: nothing else was sent.
        const auto proof = gripper.sentSince(asked);
        QCOMPARE(proof.size(), std::size_t(3));
        QVERIFY(proof[2].id == ReportId::Heartbeat && proof[2].ms == proof[1].ms);
        QVERIFY(proof[0].id == ReportId::Arm && proof[1].id == ReportId::Arm);
        QVERIFY2(proof[1].ms - proof[0].ms >= 100 && proof[1].ms - proof[0].ms <= 105,
                 qPrintable(inWords(proof)));
        gripper.squeeze();
        QVERIFY(gripper.runUntil([&] { return !samplesMoving(gripper.samples).empty(); }));
        gripper.run(300);
        const std::int64_t pressed = gripper.ms;
        gripper.control.stop(gripper.now());
        QVERIFY(gripper.control.squeeze().state == SqueezeState::Stopped);
        QVERIFY(gripper.runUntil(
            [&] { return gripper.control.stopState(gripper.now()) == StopState::Obeyed; }, 150));
        gripper.run(300);
        tell("honest", gripper, pressed, gripper.control.disarmReason());
        threeStopsThenSilence(gripper, pressed);
        QCOMPARE(gripper.sentSince(pressed).size(), std::size_t(3));
        QVERIFY(gripper.control.stopState(gripper.now()) == StopState::Obeyed);
        QVERIFY(!gripper.control.disarmReason() && !gripper.control.error());
        // The proof is given once.
        const std::int64_t again = gripper.ms;
        QVERIFY(gripper.arm());
        QCOMPARE(gripper.count(ReportId::Arm, again), std::int64_t(1));
    }

    void heartbeatsComeEvery25msAndEndWithTheScreen()
    {
        LyingGripper gripper({});
        gripper.run(20);
        QVERIFY(gripper.arm());
        const std::int64_t armed = gripper.ms;
        gripper.run(1000);
        QVERIFY(std::abs(gripper.count(ReportId::Heartbeat, armed) - 40) <= 2);
        gripper.alive = false;
        const std::int64_t frozen = gripper.ms;
        QVERIFY(gripper.runUntil([&] { return !gripper.control.armed(); }, 700));
        QVERIFY(gripper.ms - frozen > 500 && gripper.ms - frozen <= 500 + 100 + 30);
        QVERIFY(gripper.control.disarmReason()->describe().contains(u"stood still"));
        QVERIFY(std::abs(gripper.count(ReportId::Heartbeat, frozen) - 20) <= 2);
    }

    void whoDoesNotObeyStopIsToldAndLeftToItsWatchdog_data()
    {
        QTest::addColumn<bool>("answers");
        QTest::addColumn<bool>("hidesArmed");
        QTest::newRow("ignores Stop") << false << false;
        QTest::newRow("acknowledged, not done") << true << false;
        QTest::newRow("acknowledged, force stays") << true << true;
        QTest::newRow("says disarmed, force stays") << false << true;
    }
    void whoDoesNotObeyStopIsToldAndLeftToItsWatchdog()
    {
        QFETCH(bool, answers);
        QFETCH(bool, hidesArmed);
        LyingGripper gripper({});
        QVERIFY(armAndSqueeze(gripper));
        gripper.run(100);
        Lies lies;
        lies.dropsStops = lies.feedsItself = true;
        lies.answersStops = answers;
        lies.hidesArmed = hidesArmed;
        gripper.tell(lies);
        const std::int64_t pressed = gripper.ms;
        gripper.control.stop(gripper.now());
        gripper.run(149);
        QVERIFY(gripper.control.stopState(gripper.now()) == StopState::Waiting);
        gripper.run(5);
        QVERIFY(gripper.control.stopState(gripper.now()) == StopState::NotObeyed);
        tell(QTest::currentDataTag(), gripper, pressed, gripper.control.error());
        QVERIFY(gripper.control.error()->describe().contains(disobeyed));
        QVERIFY(gripper.control.squeeze().state == SqueezeState::Stopped);
        QVERIFY(!gripper.control.armed());
        gripper.run(600);
        threeStopsThenSilence(gripper, pressed);
        QCOMPARE(gripper.sentSince(pressed).size(), std::size_t(3));
        // Whatever it says later: it is not armed again by this connection, and Stop goes out whenever asked
        // for.
        gripper.tell({});
        gripper.run(500);
        QVERIFY(!gripper.arm());
        QCOMPARE(gripper.count(ReportId::Arm, pressed), std::int64_t(0));
        QVERIFY(gripper.control.stopState(gripper.now()) == StopState::NotObeyed);
        QVERIFY(gripper.control.error()->describe().contains(disobeyed));
        const std::int64_t again = gripper.ms;
        gripper.control.stop(gripper.now());
        gripper.run(300);
        threeStopsThenSilence(gripper, again);
    }

    void aWriteThatHangsIsToldAsAStopThatWasNotObeyed_data()
    {
        QTest::addColumn<int>("hangsBefore_ms"); ///< before Stop is pressed
        QTest::addColumn<int>("told_ms");
        // Where the writer already hangs, it is granted a moment to come back.
        QTest::newRow("the Stop itself hangs") << 0 << 150;
        QTest::newRow("a heartbeat hangs already") << 60 << 200;
    }
    void aWriteThatHangsIsToldAsAStopThatWasNotObeyed()
    {
        QFETCH(int, hangsBefore_ms);
        QFETCH(int, told_ms);
        LyingGripper gripper({});
        QVERIFY(armAndSqueeze(gripper));
        Lies lies;
        lies.writeHangs = lies.feedsItself = true;
        gripper.tell(lies);
        gripper.run(hangsBefore_ms);
        const std::int64_t pressed = gripper.ms;
        gripper.control.stop(gripper.now());
        gripper.run(told_ms - 1);
        QVERIFY(gripper.control.stopState(gripper.now()) == StopState::Waiting);
        gripper.run(3);
        QVERIFY(gripper.control.stopState(gripper.now()) == StopState::NotObeyed);
        tell(QTest::currentDataTag(), gripper, pressed, gripper.control.error());
    }

    void whoObeysTooLateDidNotObey()
    {
        LyingGripper gripper({});
        QVERIFY(armAndSqueeze(gripper));
        Lies lies;
        lies.dropsStops = lies.feedsItself = true;
        gripper.tell(lies);
        gripper.control.stop(gripper.now());
        gripper.run(160);
        gripper.tell({}); // its watchdog trips now
        gripper.run(300);
        QVERIFY(gripper.control.stopState(gripper.now()) == StopState::NotObeyed);
    }

    void whatGoesWrongWhileArmedIsStoppedByTheLinkItself_data()
    {
        QTest::addColumn<bool>("squeezes");
        QTest::addColumn<std::function<void(Lies&)>>("lie");
        QTest::addColumn<int>("within_ms");
        QTest::addColumn<QString>("told");
        const auto row = [](const char* tag, bool squeezes, std::function<void(Lies&)> lie, int within_ms,
                            const QString& told) {
            QTest::newRow(tag) << squeezes << std::move(lie) << within_ms << told;
        };
        // Three samples are 1.5 ms; a report may have been under way.
        row(
            "10 times the force, no moving bit", true,
            [](Lies& l) { l.forceTimes = 10, l.hidesMoving = true; }, 5, u"above the limit of 40 N"_s);
        row(
            "10 times the force", true, [](Lies& l) { l.forceTimes = 10; }, 5, u"above the limit of 40 N"_s);
        row(
            "runaway force while idle", false, [](Lies& l) { l.pushes_N = 500; }, 5,
            u"above the limit of 100 N"_s);
        row(
            "a pull while idle", false, [](Lies& l) { l.pushes_N = -500; }, 5, u"above the limit of 100 N"_s);
        row(
            "runaway travel while idle", false, [](Lies& l) { l.creeps_m = 0.03; }, 5,
            u"above the limit of 25 mm"_s);
        row(
            "runaway travel in a squeeze", true, [](Lies& l) { l.creeps_m = -0.02; }, 5,
            u"above the limit of 10 mm"_s);
        row(
            "silent while idle", false, [](Lies& l) { l.silent = true; }, 55, u"no samples came for 50 ms"_s);
        row(
            "silent in a squeeze", true, [](Lies& l) { l.silent = true; }, 55,
            u"no samples came for 50 ms"_s);
        row(
            "damaged reports", true, [](Lies& l) { l.damaged = true; }, 55, u"damaged"_s);
        row(
            "fault bit", true, [](Lies& l) { l.fault = true; }, 5, u"reports a fault"_s);
        row(
            "another program speaks", true, [](Lies& l) { l.foreignAnswers = true; }, 5,
            u"another program sends it commands"_s);
    }
    void whatGoesWrongWhileArmedIsStoppedByTheLinkItself()
    {
        QFETCH(bool, squeezes);
        QFETCH(std::function<void(Lies&)>, lie);
        QFETCH(int, within_ms);
        QFETCH(QString, told);
        LyingGripper gripper({});
        if (squeezes) {
            QVERIFY(armAndSqueeze(gripper));
        } else {
            gripper.run(20);
            QVERIFY(gripper.arm());
        }
        gripper.run(200);
        Lies lies;
        lie(lies);
        gripper.tell(lies);
        const std::int64_t since = gripper.ms;
        gripper.run(within_ms);
        tell(QTest::currentDataTag(), gripper, since, gripper.control.disarmReason());
        QVERIFY(gripper.count(ReportId::Stop, since) >= 1);
        QVERIFY(!gripper.control.armed());
        QVERIFY2(gripper.control.disarmReason()->describe().contains(told),
                 qPrintable(gripper.control.disarmReason()->describe()));
        QVERIFY(!squeezes || gripper.control.squeeze().state == SqueezeState::Stopped);
        gripper.run(400);
        const auto stops = gripper.sentSince(since);
        const auto first = std::find_if(stops.begin(), stops.end(), [](const LyingGripper::Sent& one) {
            return one.id == ReportId::Stop;
        });
        threeStopsThenSilence(gripper, since + first->ms);
    }

    void whoCannotBeTrustedIsNotArmed_data()
    {
        QTest::addColumn<std::function<void(Lies&)>>("lie");
        QTest::addColumn<std::function<void(DeviceDescription&)>>("says");
        QTest::addColumn<bool>("hasWatchdog");
        QTest::addColumn<QString>("told");
        const std::function<void(Lies&)> honest = [](Lies&) {};
        const std::function<void(DeviceDescription&)> asItIs = [](DeviceDescription&) {};
        const auto says = [&](const char* tag, std::function<void(DeviceDescription&)> what,
                              const QString& told) {
            QTest::newRow(tag) << honest << std::move(what) << true << told;
        };
        QTest::newRow("watchdog stated and absent") << honest << asItIs << false << u"does not work"_s;
        says("trips at 100 of stated 200 ms is right",
             [](DeviceDescription& d) { d.measurement.watchdog_ms = 200; }, {});
        says(
            "trips too early", [](DeviceDescription& d) { d.measurement.watchdog_ms = 240; },
            u"trips after 100 ms already"_s);
        const auto lies = [&](const char* tag, std::function<void(Lies&)> lie, const QString& told) {
            QTest::newRow(tag) << std::move(lie) << asItIs << true << told;
        };
        lies(
            "reports every 25 ms", [](Lies& l) { l.reportEvery_ms = 25; },
            u"its reports come every 25.0 ms"_s);
        lies("reports every 20 ms are enough", [](Lies& l) { l.reportEvery_ms = 20; }, {});
        lies(
            "no samples at all", [](Lies& l) { l.silent = true; }, u"good samples do not come"_s);
        lies(
            "damaged reports", [](Lies& l) { l.damaged = true; }, u"good samples do not come"_s);
        lies(
            "another program speaks", [](Lies& l) { l.foreignAnswers = true; }, u"another program"_s);
        lies(
            "its answers get lost", [](Lies& l) { l.losesArmAnswers = true; }, u"did not arm within"_s);
    }
    void whoCannotBeTrustedIsNotArmed()
    {
        QFETCH(std::function<void(Lies&)>, lie);
        QFETCH(std::function<void(DeviceDescription&)>, says);
        QFETCH(bool, hasWatchdog);
        QFETCH(QString, told);
        Lies lies;
        lie(lies);
        VirtualFirmwareOptions options = LyingGripper::honest();
        options.hasWatchdog = hasWatchdog;
        LyingGripper gripper(lies, options, says);
        gripper.run(lies.reportEvery_ms * 12);
        const bool armed = gripper.arm();
        tell(QTest::currentDataTag(), gripper, 0, gripper.control.error());
        QCOMPARE(armed, told.isEmpty());
        QCOMPARE(gripper.control.error().has_value(), !armed);
        if (armed)
            return;
        QVERIFY2(gripper.control.error()->describe().contains(told),
                 qPrintable(gripper.control.error()->describe()));
        // What may have been armed is stopped; no heartbeat was ever sent.
        QCOMPARE(gripper.count(ReportId::Heartbeat), std::int64_t(0));
        QVERIFY(gripper.count(ReportId::Arm) == 0 || gripper.count(ReportId::Stop) == 3);
    }

    void whoWasArmedByNobodyHereIsStopped()
    {
        LyingGripper gripper({});
        gripper.run(50);
        QVERIFY(gripper.sent.empty());
        Lies lies;
        lies.armsItself = true;
        gripper.tell(lies);
        gripper.run(2);
        tell("armed by nobody here", gripper, 50, gripper.control.disarmReason());
        QCOMPARE(gripper.count(ReportId::Stop), std::int64_t(1));
        QVERIFY(gripper.control.disarmReason()->describe().contains(u"did not arm it"));
    }

    void whoDisarmsItselfSaysWhy_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("told");
        QTest::newRow("watchdog") << int(StatusWatchdog) << u"no longer heard"_s;
        QTest::newRow("force limit") << int(StatusForceLimit) << u"force limit"_s;
        QTest::newRow("travel limit") << int(StatusTravelLimit) << u"travel limit"_s;
        QTest::newRow("fault") << int(StatusFault) << u"fault"_s;
        QTest::newRow("no bit") << 0 << u"without a reason"_s;
    }
    void whoDisarmsItselfSaysWhy()
    {
        QFETCH(int, status);
        QFETCH(QString, told);
        LyingGripper gripper({});
        gripper.run(20);
        QVERIFY(gripper.arm());
        gripper.control.takeState(
            {static_cast<std::uint16_t>(status), std::uint32_t(1000 * gripper.ms + 1000)}, gripper.now());
        QVERIFY(!gripper.control.armed());
        QVERIFY(gripper.control.disarmReason()->describe().contains(told));
    }

    void aStopInTheSilenceTakesBackAWishToArm()
    {
        LyingGripper gripper({});
        gripper.run(50);
        QVERIFY(gripper.arm());
        gripper.control.stop(gripper.now());
        gripper.run(60);
        gripper.control.arm(gripper.now());
        gripper.run(20);
        const std::int64_t pressed = gripper.ms;
        gripper.control.stop(gripper.now());
        gripper.run(1000);
        QCOMPARE(gripper.count(ReportId::Arm, pressed), std::int64_t(0));
        QVERIFY(!gripper.control.armed());
    }

    void aStopGoesThroughWhileItIsProvedAndTheProofBeginsAnew()
    {
        LyingGripper gripper({});
        gripper.run(20);
        gripper.control.arm(gripper.now());
        QVERIFY(gripper.runUntil([&] { return gripper.count(ReportId::Arm) == 1; }));
        gripper.run(30);
        const std::int64_t pressed = gripper.ms;
        gripper.control.stop(gripper.now());
        gripper.run(400);
        threeStopsThenSilence(gripper, pressed);
        QVERIFY(!gripper.control.armed());
        const std::int64_t again = gripper.ms;
        QVERIFY(gripper.arm());
        QCOMPARE(gripper.count(ReportId::Arm, again), std::int64_t(2));
    }
};

GRIPSCOPE_TEST(LyingGripperTest)
#include "lying_gripper_test.moc"
