// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/command_queue.h"
#include "tests/devices/watched_transport.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <future>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using Clock = std::chrono::steady_clock;

class DevicePortTest : public QObject {
    Q_OBJECT
private slots:
    void countsWhatAFaultyWireDoes_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::newRow("loss") << u"loss:0.05"_qs;
        QTest::newRow("duplicates") << u"duplicate:0.05"_qs;
        QTest::newRow("bad CRC") << u"crc:0.05"_qs;
        QTest::newRow("all three") << u"loss:0.2,duplicate:0.2,crc:0.2"_qs;
    }
    void countsWhatAFaultyWireDoes()
    {
        QFETCH(QString, fault);
        OpenPort gripper(u"virtual:?speed=0&seed=4&fault="_qs + fault);
        QCOMPARE(gripper.squeeze(usualForce(2000)), SqueezeState::Finished);
        gripper.port->drain(gripper.samples);
        const LinkCounters counters = gripper.port->counters();
        QCOMPARE(counters.badReports > 0, fault.contains(u"crc"));
        QCOMPARE(counters.duplicateReports > 0, fault.contains(u"duplicate"));
        QCOMPARE(counters.lostSamples > 0, fault.contains(u"loss") || fault.contains(u"crc"));
        QCOMPARE(counters.samples, std::uint64_t(gripper.samples.size()));
        // What came and what is missing make up all that was between the first and the last.
        QCOMPARE(counters.samples + counters.lostSamples,
                 gripper.samples.back().sequence - gripper.samples.front().sequence + 1);
        for (std::size_t i = 1; i < gripper.samples.size(); ++i) {
            QVERIFY(gripper.samples[i].sequence > gripper.samples[i - 1].sequence);
            QVERIFY(gripper.samples[i].time_s > gripper.samples[i - 1].time_s);
        }
    }

    void whatBefellTheStreamStandsOnTheSampleBehindIt()
    {
        OpenPort gripper(u"virtual:?speed=0&seed=4&fault=duplicate:0.05,crc:0.05"_qs);
        QCOMPARE(gripper.squeeze(usualForce(2000)), SqueezeState::Finished);
        gripper.port->drain(gripper.samples);
        std::uint64_t duplicates = 0, bad = 0;
        for (std::size_t i = 0; i < gripper.samples.size(); ++i) {
            const Sample& sample = gripper.samples[i];
            duplicates += sample.duplicates;
            bad += sample.badReports;
            const bool gap = i > 0 && sample.sequence != gripper.samples[i - 1].sequence + 1;
            // A damaged report is a gap, unless it was an answer to a command.
            QVERIFY(!gap || sample.badReports > 0);
            QVERIFY(!sample.clockStepped && sample.stall_ms == 0);
        }
        const LinkCounters counters = gripper.port->counters();
        QVERIFY(counters.sequenceGaps > 0 && counters.lastLoss);
        QCOMPARE(duplicates, counters.duplicateReports);
        QCOMPARE(bad, counters.badReports);
    }

    void aStallIsCountedWithItsLengthAndStandsOnTheSampleBehindIt()
    {
        Watched gripper(Watched::transport(1, "0.3 stall\n0.8 resume\n"));
        QVERIFY(gripper.pollUntil([&] { return gripper.port->counters().stalled; }));
        QVERIFY(gripper.pollUntil([&] {
            return !gripper.samples.empty() && gripper.samples.back().time_s > 1 &&
                   !gripper.port->counters().stalled;
        }));
        QVERIFY(gripper.port->state() == LinkState::Ready);
        std::vector<int> stalls_ms;
        for (const Sample& sample : gripper.samples)
            if (sample.stall_ms > 0)
                stalls_ms.push_back(sample.stall_ms);
        const LinkCounters counters = gripper.port->counters();
        QCOMPARE(std::uint64_t(stalls_ms.size()), counters.stalls);
        const int longest_ms = *std::max_element(stalls_ms.begin(), stalls_ms.end());
        QVERIFY(longest_ms > 400);
        QVERIFY(std::abs(longest_ms - 1000 * counters.longestStall_s) < 1.5);
        QVERIFY(counters.lostSamples >= 900 && counters.sequenceGaps >= 1);
    }

    void stepsOfTheDevicesClockAreCounted()
    {
        Watched gripper(Watched::transport(1, "0.3 clock +0.5\n0.5 clock -0.2\n"));
        QVERIFY(gripper.pollUntil([&] { return gripper.port->counters().clockSteps == 2; }));
        QVERIFY(gripper.pollUntil([&] {
            return std::count_if(gripper.samples.begin(), gripper.samples.end(),
                                 [](const Sample& sample) { return sample.clockStepped; }) == 2;
        }));
        QVERIFY(gripper.port->state() == LinkState::Ready);
        QCOMPARE(gripper.port->counters().lostSamples, std::uint64_t(0));
        for (std::size_t i = 1; i < gripper.samples.size(); ++i)
            QVERIFY(gripper.samples[i].time_s > gripper.samples[i - 1].time_s);
    }

    void theRatesAndTheLatencyAreTold()
    {
        OpenPort gripper(u"virtual:"_qs);
        QVERIFY(gripper.pollUntil([&] {
            const LinkCounters counters = gripper.port->counters();
            return counters.clocks.clock && std::abs(counters.sampleRate_Hz - 2000) < 200 &&
                   std::abs(counters.reportRate_Hz - 1000) < 100;
        }));
        const LinkCounters counters = gripper.port->counters();
        QVERIFY(counters.latency50_ms > 0 && counters.latency50_ms <= counters.latency99_ms);
        QVERIFY(counters.newestArrival);
        QVERIFY(gripper.pollUntil([&] { return !gripper.port->counters().clocks.clock->beyond(1000); }));
    }

    void commandsAreCounted()
    {
        Watched gripper(Watched::transport(1, "0 deaf start\n"));
        QVERIFY(gripper.ready() && gripper.arm());
        // Armed once for the proof of its watchdog, and once because a person asked.
        QCOMPARE(gripper.port->counters().commandsSent, std::uint64_t(2));
        QCOMPARE(gripper.port->counters().commandsAnswered, std::uint64_t(2));
        QVERIFY(gripper.gate.start(usualForce(12)).has_value());
        QVERIFY(gripper.pollUntil([&] { return gripper.port->squeezeState() == SqueezeState::Refused; }));
        const LinkCounters counters = gripper.port->counters();
        QCOMPARE(counters.commandsUnanswered, std::uint64_t(1));
        QVERIFY(counters.commandsRepeated >= std::uint64_t(LinkLimits{}.attempts - 1));
        QCOMPARE(counters.commandsSent - counters.commandsAnswered, std::uint64_t(1));
        QVERIFY(counters.heartbeats > 0);
        QCOMPARE(counters.commandsRefused, std::uint64_t(0));
    }

    void showsASaturatedForceChannel()
    {
        OpenPort gripper(u"virtual:?speed=0&fault=saturate:25"_qs);
        QCOMPARE(gripper.squeeze(usualForce(500)), SqueezeState::Finished);
        for (const Sample& sample : samplesMoving(gripper.samples)) {
            QVERIFY(sample.force <= 25.0);
            QCOMPARE(bool(sample.status & StatusForceSaturated), sample.force == 25.0);
        }
        QVERIFY(statusSeen(gripper.samples) & StatusForceSaturated);
    }

    void showsAStuckPositionChannel()
    {
        OpenPort gripper(u"virtual:?speed=0&fault=stuck"_qs);
        QCOMPARE(gripper.squeeze(usualForce(500)), SqueezeState::Finished);
        for (const Sample& sample : gripper.samples)
            QCOMPARE(sample.position, gripper.samples.front().position);
    }

    void takesTheUnitsThatTheDeviceStates()
    {
        OpenPort metres(u"virtual:?speed=0&seed=2"_qs);
        OpenPort millimetres(u"virtual:?speed=0&seed=2&fault=units"_qs);
        QCOMPARE(metres.squeeze(usualForce(100)), SqueezeState::Finished);
        QCOMPARE(millimetres.squeeze(usualForce(100)), SqueezeState::Finished);
        QCOMPARE(millimetres.port->identity().positionUnit, u"mm"_qs);
        QCOMPARE(millimetres.port->identity().limits.maxTravel_m, 0.025);
        for (std::size_t i = 0; i < metres.samples.size(); ++i)
            QVERIFY(std::abs(1000 * metres.samples[i].position - millimetres.samples[i].position) < 1e-9);
    }

    void unplugWhileReadingIsALossWithAllThatCameBefore_data()
    {
        QTest::addColumn<QString>("speed");
        QTest::newRow("as fast as it can") << u"0"_qs;
        QTest::newRow("in real time") << u"1"_qs;
    }
    void unplugWhileReadingIsALossWithAllThatCameBefore()
    {
        QFETCH(QString, speed);
        OpenPort gripper(u"virtual:?fault=unplug:0.3&speed="_qs + speed);
        if (speed == u"0") {
            QCOMPARE(gripper.squeeze(usualForce(2000)), SqueezeState::Stopped);
            QVERIFY(gripper.samples.size() > 500);
        }
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; }));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceLost);
        QVERIFY(!gripper.gate.arm(u"tester"_qs));
        // It can be connected again.
        gripper.port->open();
        QVERIFY(gripper.ready());
        QVERIFY(!gripper.port->lastError());
    }

    void aDeviceThatFallsSilentIsLost()
    {
        OpenPort gripper(u"virtual:?fault=stall:0.05"_qs);
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; }));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceLost);
    }

    void aSilentDeviceIsNoticedAtSpeedZeroOnceItIsAsked()
    {
        OpenPort gripper(u"virtual:?speed=0&fault=stall:0.1"_qs);
        QVERIFY(gripper.squeeze(usualForce(2000)) == SqueezeState::Stopped);
        QVERIFY(gripper.port->state() == LinkState::Lost);
    }

    void aFrozenOwnerStopsTheGripper()
    {
        Watched gripper(Watched::transport(1));
        QVERIFY(gripper.ready() && gripper.squeezesForLong());
        // From here on nobody says that the owner is alive.
        QVERIFY(waitFor([&] {
            gripper.port->drain(gripper.samples);
            return gripper.port->squeezeState() == SqueezeState::Stopped;
        }));
        QVERIFY(gripper.port->state() == LinkState::Ready);
        gripper.port->drain(gripper.samples);
        QVERIFY(statusSeen(gripper.samples) & StatusWatchdog);
        QVERIFY(samplesMoving(gripper.samples).size() <
                2 * 2000); // well before its end: a second, and 100 ms
    }

    void heartbeatsComeOnlyWhileArmed()
    {
        Watched gripper(Watched::transport(1));
        QVERIFY(gripper.ready());
        QVERIFY(gripper.pollUntil([&] { return gripper.samples.size() > 200; }));
        QCOMPARE(gripper.wire->heartbeats.load(), 0);
        QVERIFY(gripper.arm());
        QVERIFY(gripper.pollUntil([&] { return gripper.wire->heartbeats.load() > 5; }));
        gripper.port->disarm();
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Ready; }));
    }

    void stopReachesTheDeviceWhileTheOwnerIsBusy()
    {
        Watched gripper(Watched::transport(1));
        QVERIFY(gripper.ready() && gripper.squeezesForLong());
        // The owner does nothing here but wait for another thread, as if it were computing.
        std::future<std::int64_t> stopped = std::async(std::launch::async, [&] {
            const std::int64_t before = Clock::now().time_since_epoch().count();
            gripper.port->stop();
            return before;
        });
        const std::int64_t before = stopped.get();
        QVERIFY(waitFor([&] { return gripper.wire->stopWritten.load() != 0; }));
        const Clock::duration took(gripper.wire->stopWritten.load() - before);
        QVERIFY2(took < 4 * std::chrono::milliseconds(50), qPrintable(QString::number(took.count())));
        QVERIFY(gripper.pollUntil([&] { return gripper.port->squeezeState() == SqueezeState::Stopped; }));
        QVERIFY(gripper.port->state() == LinkState::Ready);
    }

    void whatBecameOfAStopIsKnownThoughTheWriteHangs()
    {
        Watched gripper(Watched::transport(1));
        QVERIFY(gripper.ready() && gripper.squeezesForLong());
        gripper.wire->stopWritten = 0;
        gripper.wire->writeTakes = std::chrono::seconds(5); // as a hidraw node may
        const int before = gripper.wire->heartbeats.load();
        QVERIFY(gripper.pollUntil([&] { return gripper.wire->heartbeats.load() > before; }));
        gripper.port->stop();
        QVERIFY(gripper.pollUntil([&] { return gripper.port->stopState() != StopState::Waiting; }));
        QCOMPARE(gripper.wire->stopWritten.load(), std::int64_t(0)); // it was known before that was over
        gripper.wire->writeTakes = std::chrono::milliseconds(0);
        gripper.port.reset();
        QVERIFY(waitFor([&] { return gripper.wire.use_count() <= 2; }));
    }

    void stopOvertakesAnUpload()
    {
        Watched gripper(Watched::transport(1, "0 deaf upload")); // it never gets through
        QVERIFY(gripper.ready() && gripper.arm());
        QVERIFY(gripper.gate.start(usualForce(20000)).has_value());
        QVERIFY(gripper.port->squeezeState() == SqueezeState::Uploading);
        gripper.port->stop();
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Ready; }));
        QCOMPARE(gripper.port->squeezeState(), SqueezeState::Stopped);
        QVERIFY(samplesMoving(gripper.samples).empty());
    }

    void aDeviceThatDoesNotAnswerACommandIsToldSo()
    {
        Watched gripper(Watched::transport(1, "0 deaf start"));
        QVERIFY(gripper.ready() && gripper.arm());
        QVERIFY(gripper.gate.start(usualForce(100)).has_value());
        QVERIFY(gripper.pollUntil([&] { return gripper.port->squeezeState() == SqueezeState::Refused; }));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceTimeout);
        QVERIFY(samplesMoving(gripper.samples).empty());
    }

    void whatTheDeviceRefusesIsTold()
    {
        OpenPort gripper(u"virtual:?speed=0"_qs);
        QVERIFY(gripper.ready() && gripper.arm());
        const AdmittedExcitation excitation = gripper.gate.admit(usualForce(100)).value();
        gripper.port->disarm();
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Ready; }));
        gripper.port->startExcitation(excitation); // past the gate's own look at the armed state
        QVERIFY(gripper.pollUntil([&] { return gripper.squeezeEnded(); }));
        QCOMPARE(gripper.port->squeezeState(), SqueezeState::Refused);
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceRefused);
    }

    void theTravelLimitOfTheJobIsKeptByTheDevice()
    {
        OpenPort gripper(u"virtual:?speed=0&object=A"_qs);
        gripper.gate.setJobLimits({50, 0.001}); // 30 N on 10,000 N/m go 3 mm
        QVERIFY(gripper.ready() && gripper.arm());
        QCOMPARE(gripper.squeeze(usualForce(1000)), SqueezeState::Stopped);
        // The program's own watch may have stopped it a report before the device says why it did.
        QVERIFY(gripper.pollUntil([&] { return statusSeen(gripper.samples) & StatusTravelLimit; }));
    }

    void closingIsBoundedWhateverTheDeviceDoes_data()
    {
        QTest::addColumn<int>("open_ms");
        QTest::addColumn<int>("read_ms");
        QTest::addColumn<int>("write_ms");
        QTest::newRow("opening hangs") << 2500 << 0 << 0;
        QTest::newRow("reading hangs") << 0 << 2500 << 0;
        QTest::newRow("writing hangs") << 0 << 0 << 2500;
        QTest::newRow("nothing hangs") << 0 << 0 << 0;
    }
    void closingIsBoundedWhateverTheDeviceDoes()
    {
        QFETCH(int, open_ms);
        QFETCH(int, read_ms);
        QFETCH(int, write_ms);
        const auto wire = Watched::transport(1);
        wire->openTakes = std::chrono::milliseconds(open_ms);
        Watched gripper(wire);
        if (open_ms == 0) {
            QVERIFY(gripper.ready() && gripper.arm());
            wire->readTakes = std::chrono::milliseconds(read_ms);
            wire->writeTakes = std::chrono::milliseconds(write_ms);
            // A writer that hangs does so from the next heartbeat on; there is none unless the screen lives.
            const int before = wire->heartbeats.load();
            QVERIFY(gripper.pollUntil([&] { return wire->heartbeats.load() > before; }));
        }
        const auto before = Clock::now();
        gripper.port->close();
        const auto took = Clock::now() - before;
        // It promises a second; what hangs would take two and a half.
        QVERIFY(took < std::chrono::milliseconds(2000));
        QVERIFY(gripper.port->state() == LinkState::Closed);
        // Threads left behind must end before the test does.
        gripper.port.reset();
        QVERIFY(waitFor([&] { return wire.use_count() <= 2; }));
    }

    void closingWhileArmedStopsTheGripper()
    {
        Watched gripper(Watched::transport(1));
        QVERIFY(gripper.ready() && gripper.squeezesForLong());
        gripper.port->close();
        QVERIFY(gripper.wire->stopWritten.load() != 0);
    }

    void aProgramThatDoesNotKeepUpLosesTheNewestAndCountsThem()
    {
        VirtualAddress address;
        address.speed = 0;
        const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
            return *VirtualTransport::make(address);
        };
        OpenPort gripper(std::make_unique<DevicePort>(u"virtual:"_qs, make, 100));
        QVERIFY(gripper.ready() && gripper.arm());
        QVERIFY(gripper.gate.start(usualForce(1000)).has_value());
        constexpr std::uint64_t all = 100 + 1000 + 120;
        QVERIFY(waitFor([&] {
            gripper.port->confirmAlive();
            const LinkCounters counters = gripper.port->counters();
            return counters.samples + counters.droppedSamples == all;
        }));
        QCOMPARE(gripper.port->counters().droppedSamples, all - 100);
        QCOMPARE(gripper.port->drain(gripper.samples), std::size_t(100));
        QCOMPARE(gripper.samples.back().sequence, std::uint64_t(99));
    }

    void aClosedPortIsQuiet()
    {
        const auto port = DeviceFactory().create(u"virtual:"_qs).value();
        std::vector<Sample> samples;
        QVERIFY(port->state() == LinkState::Closed);
        QCOMPARE(port->drain(samples), std::size_t(0));
        port->stop();
        port->disarm();
        port->close();
        QCOMPARE(port->squeezeState(), SqueezeState::Idle);
        QCOMPARE(port->counters().reports, std::uint64_t(0));
    }
};

GRIPSCOPE_TEST(DevicePortTest)
#include "device_port_test.moc"
