// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/session/touched_plant.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;

/// When the next part is squeezed by itself, in virtual time.
class AutomaticSqueezeTest : public QObject {
    Q_OBJECT
private slots:
    void aPartThatTouchesIsSqueezedAfterTheCountdown()
    {
        TouchedPlant plant = plantAtRest();
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
        plant.force = partForce;
        plant.runUntilCounting();
        QCOMPARE(plant.state(), SqueezeWait::Counting);
        QVERIFY(plant.last.remaining_s > 1.9 && plant.last.remaining_s <= 2);
        plant.run(1.8);
        QCOMPARE(plant.squeezes, 0);
        QVERIFY(plant.last.remaining_s < 0.25);
        plant.run(0.3);
        QCOMPARE(plant.squeezes, 1);
        QCOMPARE(plant.state(), SqueezeWait::Occupied);
        plant.run(30); // once
        QCOMPARE(plant.squeezes, 1);
    }
    void noiseIsNoPart_data()
    {
        QTest::addColumn<double>("deviation");
        QTest::newRow("the usual") << idleNoise;
        QTest::newRow("a hundred times as much") << 100 * idleNoise;
        QTest::newRow("next to none") << 1e-9;
    }
    void noiseIsNoPart()
    {
        QFETCH(double, deviation);
        TouchedPlant plant;
        plant.sampleNoise = deviation;
        plant.run(600);
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
        QCOMPARE(plant.countdowns, 0);
    }
    void theThresholdIsOfItsOwnNoise()
    {
        TouchedPlant plant;
        plant.sampleNoise = 5 * idleNoise;
        plant.run(1.5);
        plant.force = partForce; // five standard deviations here
        plant.run(10);
        QCOMPARE(plant.countdowns, 0);
    }
    void aSensorWithoutNoiseTellsNothingWithoutALimit()
    {
        TouchedPlant none;
        none.sampleNoise = 0;
        none.run(5);
        QCOMPARE(none.state(), SqueezeWait::Learning);
        AutomaticSqueezeOptions options;
        options.leastTouch = 0.1;
        TouchedPlant limited(options);
        limited.sampleNoise = 0;
        limited.run(1.5);
        QCOMPARE(limited.state(), SqueezeWait::Waiting);
        limited.force = 0.09;
        limited.run(5);
        QCOMPARE(limited.countdowns, 0);
        limited.force += 0.12;
        limited.run(3);
        QCOMPARE(limited.squeezes, 1);
    }
    void slowDriftIsNoPart()
    {
        for (const double perSecond : {0.02, -0.02}) { // 12 N in ten minutes
            TouchedPlant plant = plantAtRest();
            plant.drift = perSecond;
            plant.run(600);
            QCOMPARE(plant.countdowns, 0);
            QCOMPARE(plant.state(), SqueezeWait::Waiting);
            plant.drift = 0;
            plant.force += partForce; // and is no hindrance
            plant.run(3);
            QCOMPARE(plant.squeezes, 1);
        }
    }
    void aBouncingPartIsCountedFromItsLastBounce()
    {
        TouchedPlant plant = plantAtRest();
        for (int i = 0; i < 6; ++i) {
            plant.force = partForce;
            plant.run(0.1);
            plant.force = 0;
            plant.run(0.1);
        }
        QCOMPARE(plant.countdowns, 0);
        plant.force = partForce;
        plant.run(2.1);
        QCOMPARE(plant.squeezes, 0);
        plant.run(0.6);
        QCOMPARE(plant.squeezes, 1);
        QCOMPARE(plant.countdowns, 1);
    }
    void aTouchAndAwayIsNoPart()
    {
        TouchedPlant plant = plantAtRest();
        plant.force = partForce;
        plant.run(0.2);
        plant.force = 0;
        plant.run(10);
        QCOMPARE(plant.countdowns, 0);
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
    }
    void anyChangeEndsTheCountdownUntilThePartHasLeft()
    {
        for (const double change : {0.3, -0.2}) { // a hand presses, a hand lets go
            TouchedPlant plant = plantCounting();
            plant.run(1.9);
            plant.force += change;
            plant.run(0.064);
            QCOMPARE(plant.state(), SqueezeWait::Occupied);
            plant.run(10);
            QCOMPARE(plant.squeezes, 0);
            plant.force = 0;
            plant.run(0.7);
            plant.force = partForce;
            plant.run(2.6);
            QCOMPARE(plant.squeezes, 1);
        }
    }
    void aForceThatNeverKeepsStillIsNeverCounted()
    {
        TouchedPlant plant = plantAtRest();
        for (int i = 0; i < 40; ++i) {
            plant.force = i % 2 ? 1 : 2; // a hand on the part
            plant.run(0.2);
        }
        QCOMPARE(plant.countdowns, 0);
    }
    void aPartThatLeavesInTheCountdownIsNotSqueezed()
    {
        TouchedPlant plant = plantCounting();
        plant.force = 0;
        plant.run(0.7);
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
        plant.run(10);
        QCOMPARE(plant.squeezes, 0);
    }
    void twoTouchesAreOneSqueezeEachThatStays()
    {
        TouchedPlant plant = plantCounting();
        plant.force = 0;
        plant.run(1);
        plant.force = partForce;
        plant.run(2);
        QCOMPARE(plant.squeezes, 0); // the countdown began anew
        plant.run(0.6);
        QCOMPARE(plant.squeezes, 1);
    }
    void whatWasSqueezedMustLeaveFirst()
    {
        TouchedPlant plant = plantCounting();
        plant.run(2.1);
        QCOMPARE(plant.squeezes, 1);
        squeezeOnce(plant);
        plant.run(5);
        plant.force = 2 * partForce; // turned, pushed: still there
        plant.run(5);
        plant.force = 0; // too short to be gone
        plant.run(0.3);
        plant.force = partForce;
        plant.run(5);
        QCOMPARE(plant.squeezes, 1);
        QCOMPARE(plant.countdowns, 1);
        plant.force = 0;
        plant.run(0.7);
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
        plant.force = partForce;
        plant.run(2.6);
        QCOMPARE(plant.squeezes, 2);
    }
    void aTouchDuringASqueezeIsNothing()
    {
        TouchedPlant plant = plantAtRest();
        plant.conditions.squeezing = plant.moving = true; // by a key
        plant.force = 20;
        plant.run(0.5);
        plant.force = partForce; // a hand, as it ends
        plant.run(0.2);
        plant.conditions.squeezing = plant.moving = false;
        plant.run(5);
        QCOMPARE(plant.countdowns, 0);
        QCOMPARE(plant.state(), SqueezeWait::Occupied);
    }
    void aKeyEndsItUntilThePartHasLeft()
    {
        TouchedPlant plant = plantCounting();
        plant.machine.interrupt();
        plant.run(10);
        QCOMPARE(plant.squeezes, 0);
        QCOMPARE(plant.state(), SqueezeWait::Occupied);
        plant.force = 0;
        plant.run(1);
        plant.force = partForce;
        plant.run(3);
        QCOMPARE(plant.squeezes, 1);
    }
    void afterStopOnlyAPersonBringsItBack_data()
    {
        QTest::addColumn<bool>("byArming");
        QTest::newRow("armed again") << true;
        QTest::newRow("squeezed by hand") << false;
    }
    void afterStopOnlyAPersonBringsItBack()
    {
        QFETCH(bool, byArming);
        TouchedPlant plant = plantCounting();
        plant.machine.stop();
        plant.run(0.1); // it says that it is armed for a moment more
        QCOMPARE(plant.state(), SqueezeWait::Occupied);
        QVERIFY(plant.last.waitsForPerson);
        if (byArming) {
            plant.conditions.armed = false;
            plant.run(1);
        }
        plant.force = 0;
        plant.run(1);
        plant.force = partForce;
        plant.run(5);
        QCOMPARE(plant.squeezes, 0);
        if (byArming) {
            plant.conditions.armed = true;
            plant.run(5); // what is there then did not arrive
        } else {
            plant.machine.squeezedByHand();
            squeezeOnce(plant);
            plant.run(5);
        }
        QCOMPARE(plant.squeezes, 0);
        QVERIFY(!plant.last.waitsForPerson);
        plant.force = 0;
        plant.run(2);
        plant.force = partForce;
        plant.run(3);
        QCOMPARE(plant.squeezes, 1);
    }
    void aStopIsNotForgottenWithTheLink()
    {
        TouchedPlant plant = plantAtRest();
        plant.machine.stop();
        plant.machine.reset();
        plant.run(1.5);
        plant.force = partForce;
        plant.run(5);
        QCOMPARE(plant.squeezes, 0);
    }
    void whatIsTakenAwayEndsTheCountdown_data()
    {
        QTest::addColumn<bool>("armed");
        QTest::addColumn<bool>("allowed");
        QTest::newRow("disarmed") << false << true;
        QTest::newRow("another page, a dialog, not ready") << true << false;
    }
    void whatIsTakenAwayEndsTheCountdown()
    {
        QFETCH(bool, armed);
        QFETCH(bool, allowed);
        TouchedPlant plant = plantCounting();
        plant.conditions = {armed, allowed, false};
        plant.run(0.016);
        QCOMPARE(plant.state(), SqueezeWait::Occupied);
        plant.run(3);
        plant.conditions = {true, true, false};
        plant.run(5); // the same part: it did not arrive since
        QCOMPARE(plant.squeezes, 0);
    }
    void whatArrivedBeforeItWasAllowedIsNotSqueezed()
    {
        TouchedPlant plant = plantAtRest();
        plant.conditions.allowed = false;
        plant.force = partForce;
        plant.run(1);
        plant.conditions.allowed = true;
        plant.run(5);
        QCOMPARE(plant.countdowns, 0);
        plant.force = 0;
        plant.run(1);
        plant.force = partForce;
        plant.run(3);
        QCOMPARE(plant.squeezes, 1);
    }
    void armingWithAPartInTheJawsIsNoArrival()
    {
        TouchedPlant plant;
        plant.conditions.armed = false;
        plant.force = partForce;
        plant.run(3);
        plant.conditions.armed = true;
        plant.run(5);
        QCOMPARE(plant.countdowns, 0);
        plant.force = 0; // it leaves: this is the rest
        plant.run(2);
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
        plant.force = partForce;
        plant.run(3);
        QCOMPARE(plant.squeezes, 1);
    }
    void aSqueezeBeforeTheRestIsKnownLeavesThePartThere()
    {
        TouchedPlant plant;
        plant.force = partForce;
        plant.run(0.3);
        squeezeOnce(plant);
        plant.run(3);
        plant.force += partForce; // pushed
        plant.run(5);
        QCOMPARE(plant.countdowns, 0);
        plant.force = 0;
        plant.run(2);
        plant.force = partForce;
        plant.run(3);
        QCOMPARE(plant.squeezes, 1);
    }
    void aPartThatLeavesBeforeTheRestIsKnownMakesRoomForTheNext()
    {
        TouchedPlant plant;
        plant.force = partForce;
        plant.run(0.3);
        squeezeOnce(plant);
        plant.run(0.4); // taken out before the force was still for a second
        plant.force = 0;
        plant.run(3);
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
        plant.force = partForce;
        plant.run(3);
        QCOMPARE(plant.squeezes, 1);
    }
    void aRestThatDriftedUnderThePartIsRest()
    {
        TouchedPlant plant = plantCounting();
        plant.run(3);
        QCOMPARE(plant.state(), SqueezeWait::Occupied);
        plant.force = 0.7 * 8 * idleNoise; // the part leaves: below the threshold, above half of it
        plant.run(2);
        QCOMPARE(plant.state(), SqueezeWait::Waiting);
        plant.force += partForce;
        plant.run(3);
        QCOMPARE(plant.squeezes, 2);
    }
    void lostSamplesBeginTheCountdownAnew()
    {
        TouchedPlant plant = plantCounting();
        plant.run(1.9);
        plant.lose(1);
        plant.run(0.016);
        QCOMPARE(plant.state(), SqueezeWait::Settling);
        plant.run(2);
        QCOMPARE(plant.squeezes, 0);
        plant.run(0.6);
        QCOMPARE(plant.squeezes, 1);
    }
    void whoLosesSamplesAllTheTimeNeverCounts()
    {
        TouchedPlant plant = plantAtRest();
        plant.force = partForce;
        for (int i = 0; i < 50; ++i) {
            plant.run(0.2);
            plant.lose(3);
        }
        QCOMPARE(plant.countdowns, 0);
    }
    void silenceEndsTheCountdown()
    {
        TouchedPlant plant = plantCounting();
        plant.silent = true;
        plant.run(0.4);
        QCOMPARE(plant.state(), SqueezeWait::Settling);
        plant.run(5);
        QCOMPARE(plant.squeezes, 0);
    }
    void aCountdownThatNobodySawIsNone()
    {
        TouchedPlant plant = plantCounting();
        plant.freeze(3); // the screen stood still
        QCOMPARE(plant.squeezes, 0);
        QVERIFY(plant.state() == SqueezeWait::Settling);
        plant.run(2.6);
        QCOMPARE(plant.squeezes, 1);
    }
    void anotherLinkIsLearnedAnew()
    {
        TouchedPlant plant = plantCounting();
        plant.machine.reset();
        plant.run(0.5);
        QCOMPARE(plant.state(), SqueezeWait::Learning);
        plant.run(5); // the part was there already
        QCOMPARE(plant.squeezes, 0);
    }
    void whatIsNoNumberEndsTheCountdown()
    {
        TouchedPlant plant = plantCounting();
        plant.machine.take({1'000'000, plant.now(), std::nan(""), false});
        plant.run(0.016);
        QCOMPARE(plant.state(), SqueezeWait::Settling);
    }
    void slowGrippersCountToo()
    {
        AutomaticSqueeze machine;
        RandomStream random(3, 1, 1);
        int squeezes = 0;
        for (int i = 1; i <= 4000; ++i) { // at 100 Hz, 40 s
            const double now_s = 0.01 * i;
            machine.take({static_cast<std::uint64_t>(i), now_s,
                          (i > 2000 ? partForce : 0) + idleNoise * random.normal(), false});
            squeezes += machine.step(now_s, {true, true, false}).squeeze ? 1 : 0;
        }
        QCOMPARE(squeezes, 1);
    }
};

GRIPSCOPE_TEST(AutomaticSqueezeTest)
#include "automatic_squeeze_test.moc"
