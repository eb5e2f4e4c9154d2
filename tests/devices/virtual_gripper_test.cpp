// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "devices/address/virtual_object.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class VirtualGripperTest : public QObject {
    Q_OBJECT
private slots:
    void saysWhatItIs()
    {
        OpenPort gripper(u"virtual:?object=C&seed=7&speed=0"_qs);
        QVERIFY(gripper.ready());
        const GripperIdentity identity = gripper.port->identity();
        QCOMPARE(identity.serial, u"VG-7"_qs);
        QCOMPARE(identity.forceUnit, u"N"_qs);
        QCOMPARE(identity.positionUnit, u"m"_qs);
        QCOMPARE(identity.sampleTime_s, 0.0005);
        QVERIFY(identity.hold == ForceHold::Zero);
        QCOMPARE(identity.protocolMajor, 1);
        QVERIFY(identity.commandable);
        QCOMPARE(identity.limits.maxForce_N, 100.0);
        QCOMPARE(identity.limits.maxTravel_m, 0.025);
    }

    void squeezesAsCommanded_data()
    {
        QTest::addColumn<QString>("speed");
        QTest::newRow("as fast as it can") << u"0"_qs;
        QTest::newRow("in real time") << u"1"_qs;
        QTest::newRow("ten times faster") << u"10"_qs;
    }
    void squeezesAsCommanded()
    {
        QFETCH(QString, speed);
        const std::vector<double> force_N = usualForce(1000);
        const auto squeezes = [&](OpenPort& one) {
            return one.ready() && one.arm() && one.gate.start(force_N) &&
                   one.pollUntil([&] { return one.squeezeIsOver(); }) &&
                   one.port->squeezeState() == SqueezeState::Finished;
        };
        const auto gripper = gripperThat(u"virtual:?object=A&seed=3&speed="_qs + speed, squeezes);
        QVERIFY(gripper);
        const std::vector<Sample> squeeze = samplesMoving(gripper->samples);
        QCOMPARE(squeeze.size(), force_N.size());
        // What a held force does to the object of the first draw, exactly.
        const MassDampingStiffness object = VirtualObject::fromText(u"A"_qs)->draw(3, 0);
        const std::vector<double> expected = simulate(object, force_N, {0.0005, ForceHold::Zero, 0, 0, 0, 0});
        double offset = 0;
        for (std::size_t i = 0; i < squeeze.size(); ++i)
            offset += (squeeze[i].position - expected[i]) / static_cast<double>(squeeze.size());
        for (std::size_t i = 0; i < squeeze.size(); ++i) {
            // Six standard deviations of the noise (0.02 N; 5 um) and half a step of 20 um.
            QVERIFY(std::abs(squeeze[i].force - force_N[i]) < 6 * 0.02);
            QVERIFY(std::abs(squeeze[i].position - offset - expected[i]) < 6 * 5e-6 + 10e-6 + 2e-6);
            QCOMPARE(squeeze[i].sequence, squeeze.front().sequence + i);
            QVERIFY(std::abs(squeeze[i].time_s - squeeze.front().time_s - 0.0005 * static_cast<double>(i)) <
                    1e-9);
        }
        const LinkCounters counters = gripper->port->counters();
        QCOMPARE(counters.lostSamples, std::uint64_t(0));
        QCOMPARE(counters.badReports, std::uint64_t(0));
        QCOMPARE(counters.droppedSamples, std::uint64_t(0));
    }

    void takesTheNextSqueezeWhileItSettles()
    {
        const auto squeezesTwice = [](OpenPort& gripper) {
            const auto settled = [&] { // 10 ms of rest after the force, of the 60 that the device gives
                std::size_t rest = 0;
                for (auto sample = gripper.samples.rbegin(); sample != gripper.samples.rend();
                     ++sample, ++rest)
                    if (sample->status & StatusMoving)
                        return rest >= 20;
                return false;
            };
            const auto armed = [&] { return gripper.port->state() == LinkState::Armed; };
            return gripper.ready() && gripper.arm() && gripper.gate.start(usualForce(200)) &&
                   gripper.pollUntil([&] { return settled() || !armed(); }) && armed() &&
                   gripper.gate.start(usualForce(200)) &&
                   gripper.pollUntil([&] { return gripper.squeezeIsOver(); }) && armed();
        };
        const auto gripper = gripperThat(u"virtual:?object=B&speed=1"_qs, squeezesTwice);
        QVERIFY(gripper);
        QCOMPARE(gripper->port->squeezeState(), SqueezeState::Finished);
        QCOMPARE(samplesMoving(gripper->samples).size(), std::size_t(400));
    }

    void asFastAsItCanIsTheSameOnEveryRun()
    {
        const QString address =
            u"virtual:?object=B&seed=11&speed=0&fault=loss:0.02,crc:0.01,duplicate:0.01"_qs;
        std::vector<std::vector<Sample>> runs;
        for (int run = 0; run < 2; ++run) {
            OpenPort gripper(address);
            for (int squeeze = 0; squeeze < 3; ++squeeze)
                QCOMPARE(gripper.squeeze(usualForce(600)), SqueezeState::Finished);
            runs.push_back(gripper.samples);
            QVERIFY(gripper.port->counters().lostSamples > 0);
        }
        QCOMPARE(runs[0].size(), runs[1].size());
        for (std::size_t i = 0; i < runs[0].size(); ++i) {
            QCOMPARE(runs[0][i].sequence, runs[1][i].sequence);
            QCOMPARE(runs[0][i].time_s, runs[1][i].time_s);
            QCOMPARE(runs[0][i].force, runs[1][i].force);
            QCOMPARE(runs[0][i].position, runs[1][i].position);
            // But for the armed bit after the squeezes, nothing depends on when commands come.
            QCOMPARE(runs[0][i].status, runs[1][i].status);
        }
    }

    void theNthSqueezeDependsOnSeedAndNumberAlone()
    {
        OpenPort first(u"virtual:?object=D&seed=5&speed=0"_qs);
        QCOMPARE(first.squeeze(usualForce(300)), SqueezeState::Finished);
        first.samples.clear();
        QCOMPARE(first.squeeze(usualForce(400)), SqueezeState::Finished);
        OpenPort second(u"virtual:?object=D&seed=5&speed=0"_qs);
        QCOMPARE(second.squeeze(usualForce(800)), SqueezeState::Finished);
        second.samples.clear();
        QCOMPARE(second.squeeze(usualForce(400)), SqueezeState::Finished);
        const std::vector<Sample> a = samplesMoving(first.samples);
        const std::vector<Sample> b = samplesMoving(second.samples);
        QCOMPARE(a.size(), std::size_t(400));
        QCOMPARE(b.size(), a.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            QCOMPARE(a[i].force, b[i].force);
            QCOMPARE(a[i].position, b[i].position);
        }
    }

    void passesTimeAtSpeedZeroOnlyWhileItSqueezes()
    {
        OpenPort gripper(u"virtual:?speed=0"_qs);
        QVERIFY(gripper.ready());
        QVERIFY(gripper.arm());
        QCOMPARE(gripper.samples.size(), std::size_t(0));
        QCOMPARE(gripper.squeeze(usualForce(100)), SqueezeState::Finished);
        gripper.port->drain(gripper.samples);
        QCOMPARE(gripper.samples.size(), std::size_t(100 + 100 + 120)); // rest, movement, rest
        QCOMPARE(gripper.samples.front().time_s, 0.0);
    }
};

GRIPSCOPE_TEST(VirtualGripperTest)
#include "virtual_gripper_test.moc"
