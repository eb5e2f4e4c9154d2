// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/device_steps.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

// What devices/PROTOCOL.md says of a device, row by row, held against the virtual one.

namespace {

/// Each sample with its status.
std::vector<std::pair<RawSample, std::uint16_t>> samplesOf(const BareDevice& d)
{
    std::vector<std::pair<RawSample, std::uint16_t>> out;
    for (const StreamReport& report : d.stream)
        for (std::size_t i = 0; i < report.count; ++i)
            out.emplace_back(report.samples[i], report.status);
    return out;
}

} // namespace

class FirmwareRulesTest : public QObject {
    Q_OBJECT
private slots:
    void powerUpIsAsStated()
    {
        BareDevice device;
        device.run(10);
        QCOMPARE(device.lastStatus(), std::uint16_t(0));
        QVERIFY(device.stream.back().excitation == ExcitationState::None);
        QCOMPARE(device.stream.back().excitationNumber, std::uint16_t(0));
        QCOMPARE(device.send(ArmCommand{9}).detail, 0U);
        QCOMPARE(device.upload(Forces(1, ownForce), 1), CommandResult::Done); // the limits are its own
    }

    void aTokenArmsOnce_data()
    {
        QTest::addColumn<Steps>("disarm");
        QTest::newRow("Stop") << Steps([](BareDevice& d) { d.send(StopCommand{}); });
        QTest::newRow("Disarm") << Steps([](BareDevice& d) { d.send(DisarmCommand{}); });
        QTest::newRow("watchdog") << Steps([](BareDevice& d) { d.run(300, false); });
        QTest::newRow("force limit") << Steps([](BareDevice& d) { weight(d, 150), d.run(10), weight(d, 0); });
        QTest::newRow("fault") << Steps([](BareDevice& d) { broken(d), d.run(100), broken(d, false); });
    }
    void aTokenArmsOnce()
    {
        QFETCH(Steps, disarm);
        BareDevice device(quiet());
        const Command arm{1, ArmCommand{0x5EED}};
        QVERIFY(device.send(arm).status & StatusArmed);
        QVERIFY(device.send(arm).status & StatusArmed); // repeated while armed: nothing happens
        disarm(device);
        const Acknowledgement again = device.send(arm);
        QVERIFY(again.result == CommandResult::Repeated);
        QVERIFY(!(again.status & StatusArmed));
        device.run(10);
        QVERIFY(!(device.lastStatus() & StatusArmed));
        const Acknowledgement next = device.send(ArmCommand{0x5EEE});
        QVERIFY(next.result == CommandResult::Done);
        QCOMPARE(next.status, std::uint16_t(StatusArmed)); // the cause is cleared
        QVERIFY(device.send(StopCommand{}).result == CommandResult::Done);
        // One that was answered while armed is remembered too.
        device.send(ArmCommand{3});
        device.send(ArmCommand{4});
        device.send(StopCommand{});
        QVERIFY(!(device.send(ArmCommand{4}).status & StatusArmed));
        QVERIFY(device.send(ArmCommand{}).status & StatusArmed); // one without a token always arms
        device.send(StopCommand{});
        QVERIFY(device.send(ArmCommand{}).status & StatusArmed);
    }

    void aDeviceOfVersion10KnowsNoToken()
    {
        VirtualFirmwareOptions options = quiet();
        options.protocolMinor = 0;
        BareDevice device(options);
        QCOMPARE(int(decodeIdentity(*device.firmware.feature(0x10))->protocolMinor), 0);
        device.firmware.receive(encode(Command{1, ArmCommand{7}}), 0);
        QCOMPARE(int(device.firmware.outbox().back()[1]), 0x10);
        device.send(StopCommand{});
        QVERIFY(device.send(ArmCommand{7}).status & StatusArmed);
        QCOMPARE(int(decodeIdentity(*BareDevice().firmware.feature(0x10))->protocolMinor), 1);
    }

    void onlyWhatWasTakenFeedsTheWatchdog_data()
    {
        QTest::addColumn<Steps>("each25ms");
        QTest::addColumn<bool>("feeds");
        const auto row = [](const char* name, CommandBody body, bool feeds) {
            QTest::newRow(name) << Steps([body](BareDevice& d) { d.send(body); }) << feeds;
        };
        row("Heartbeat", HeartbeatCommand{}, true);
        row("Set limits", SetLimitsCommand{ownForce, ownTravel}, true);
        row("Upload", chunk(1, 0, {1}), true);
        row("Finish of nothing", FinishCommand{9}, true);
        row("nothing but a late Arm", ArmCommand{1}, false);
        row("refused limits", SetLimitsCommand{0, 0}, false);
        row("refused Upload", chunk(1, 0, {-1}), false);
        row("refused Start", StartCommand{1, 1, 0}, false);
        const auto bytes = [](const char* name, std::size_t at, std::uint8_t value, bool sealedAgain) {
            QTest::newRow(name) << Steps([=](BareDevice& d) {
                Report report = encode(Command{7, HeartbeatCommand{}});
                report[at] = value;
                if (sealedAgain)
                    seal(report);
                d.firmware.receive(report, d.now_us);
                std::erase_if(d.firmware.outbox(),
                              [](const Report& r) { return r[0] == 0x02; }); // its answer
            }) << false;
        };
        bytes("an unknown command", 0, 0x2F, true);
        bytes("an Arm without its key", 0, 0x20, true);
        bytes("a damaged Heartbeat", 5, 1, false);
        QTest::newRow("a request for a feature")
            << Steps([](BareDevice& d) { (void)d.firmware.feature(0x10); }) << false;
    }
    void onlyWhatWasTakenFeedsTheWatchdog()
    {
        QFETCH(Steps, each25ms);
        QFETCH(bool, feeds);
        BareDevice device(quiet());
        armed(device);
        for (int i = 0; i < 4; ++i) { // 100 ms
            device.run(50, false);
            each25ms(device);
        }
        QVERIFY(device.send(Command{99, FinishCommand{}}).status & StatusArmed);
        BareDevice again(quiet());
        armed(again);
        for (int i = 0; i < 5; ++i) { // 125 ms
            each25ms(again);
            again.run(50, false);
        }
        QCOMPARE(again.lastStatus(), std::uint16_t(feeds ? StatusArmed : StatusWatchdog));
    }

    void theWatchdogKeepsItsTime_data()
    {
        QTest::addColumn<int>("time_ms");
        for (const int time_ms : {100, 150, 200})
            QTest::addRow("%d ms", time_ms) << time_ms;
    }
    void theWatchdogKeepsItsTime()
    {
        QFETCH(int, time_ms);
        VirtualFirmwareOptions options = quiet();
        options.watchdog_ms = static_cast<std::uint16_t>(time_ms);
        BareDevice device(options);
        QCOMPARE(int(decodeMeasurement(*device.firmware.feature(0x11))->watchdog_ms), time_ms);
        armed(device);
        device.run(static_cast<std::size_t>(2 * time_ms), false); // samples of 0.5 ms
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusArmed));
        device.run(20, false); // at most 10 ms later
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusWatchdog));
    }

    void whateverDisarmsItDoesItAtOnce_data()
    {
        QTest::addColumn<Steps>("phase");
        QTest::addColumn<Steps>("cause");
        QTest::addColumn<int>("status");
        const std::pair<const char*, Steps> phases[] = {
            {"resting", resting}, {"moving", moving}, {"settling", settling}};
        const std::tuple<const char*, Steps, int> causes[] = {
            {"Stop", [](BareDevice& d) { d.send(StopCommand{}); }, 0},
            {"Disarm", [](BareDevice& d) { d.send(DisarmCommand{}); }, 0},
            {"force limit", [](BareDevice& d) { weight(d, 150), d.run(3), weight(d, 0); }, StatusForceLimit},
            {"fault", [](BareDevice& d) { broken(d); }, StatusFault}};
        for (const auto& [phase, reach] : phases)
            for (const auto& [cause, act, status] : causes)
                QTest::addRow("%s, %s", phase, cause) << reach << act << status;
    }
    void whateverDisarmsItDoesItAtOnce()
    {
        QFETCH(Steps, phase);
        QFETCH(Steps, cause);
        QFETCH(int, status);
        BareDevice device(quiet());
        phase(device);
        device.run(4);
        QVERIFY(device.lastStatus() & StatusArmed);
        cause(device);
        device.stream.clear();
        device.run(1000);
        QCOMPARE(device.pushedSamples(), std::size_t(0));
        for (const StreamReport& report : device.stream) {
            QCOMPARE(int(report.status), status);
            QVERIFY(report.excitation == ExcitationState::Stopped);
            QCOMPARE(report.excitationNumber, std::uint16_t(5));
        }
    }

    void anUploadIsForgottenByDisarming()
    {
        BareDevice device;
        loaded(device);
        QVERIFY(device.send(DisarmCommand{}).result == CommandResult::Done);
        device.run(10);
        QVERIFY(device.stream.back().excitation == ExcitationState::None);
        QCOMPARE(device.stream.back().excitationNumber, std::uint16_t(0));
        device.send(ArmCommand{2});
        QCOMPARE(device.start(push, 5), CommandResult::Incomplete);
    }

    void limitsStayUntilTheyAreSetAgain()
    {
        BareDevice device;
        device.send(SetLimitsCommand{500, 100});
        armed(device);
        device.send(StopCommand{});
        device.send(ArmCommand{2});
        QCOMPARE(device.upload({501}, 1), CommandResult::LimitExceeded);
        // Nothing of refused ones is taken, not even the number that was right.
        QVERIFY(device.send(SetLimitsCommand{ownForce, ownTravel + 1}).result ==
                CommandResult::LimitExceeded);
        QCOMPARE(device.upload({501}, 1), CommandResult::LimitExceeded);
        QCOMPARE(device.upload({500}, 1), CommandResult::Done);
    }

    void aRefusedUploadStoresNothing()
    {
        BareDevice device;
        armed(device);
        QCOMPARE(device.upload({1, 2, 3}, 1), CommandResult::Done);
        QVERIFY(device.send(chunk(1, 3, {4, ownForce + 1})).result == CommandResult::LimitExceeded);
        QVERIFY(device.send(chunk(2, 0, {-1})).result ==
                CommandResult::BadValue); // and does not begin another
        const Acknowledgement missing = device.send(StartCommand{1, 4, forcesCrc({1, 2, 3, 4})});
        QVERIFY(missing.result == CommandResult::Incomplete);
        QCOMPARE(missing.detail, 3U);
        QCOMPARE(device.start({1, 2, 3}, 1), CommandResult::Done);
    }

    void sampleICarriesForceI()
    {
        BareDevice device(quiet());
        armed(device);
        Forces forces;
        for (int i = 0; i < 300; ++i)
            forces.push_back(10000 + 37 * i);
        device.upload(forces, 1);
        device.start(forces, 1);
        device.run(1000);
        std::size_t i = 0, before = 0, behind = 0;
        std::int32_t atRest = 0;
        for (const auto& [sample, status] : samplesOf(device)) {
            if (!(status & StatusMoving)) {
                QCOMPARE(sample.force, 0);
                ++(i == 0 ? before : behind);
                atRest = i == 0 ? sample.position : atRest;
                continue;
            }
            QCOMPARE(sample.force, forces.at(i));
            if (i == 0)
                QCOMPARE(sample.position, atRest); // the first force has not moved anything yet
            if (i == 20)
                QVERIFY(sample.position > atRest); // it closes
            ++i;
        }
        QCOMPARE(i, forces.size());
        constexpr std::size_t shortestRest = 40; // 20 ms
        QVERIFY(before >= shortestRest && behind >= shortestRest);
    }

    void aPeakAtTheLimitIsNotStoppedByNoise()
    {
        BareDevice device; // 20 counts of noise
        armed(device);
        device.send(SetLimitsCommand{10000, ownTravel});
        const Forces longPush(20000, 10000);
        device.upload(longPush, 1);
        QCOMPARE(device.start(longPush, 1), CommandResult::Done);
        device.run(21000);
        QCOMPARE(device.pushedSamples(), longPush.size());
        QVERIFY(device.stream.back().excitation == ExcitationState::Finished);
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusArmed));
    }

    void aMeasuredForceBeyondTheThresholdStopsIt_data()
    {
        QTest::addColumn<double>("load_N");
        QTest::addColumn<std::size_t>("samples");
        QTest::addColumn<bool>("moves");
        QTest::addColumn<bool>("stops");
        // The limit is 10 N: the threshold is 10 + 0.5 + 1 N.
        QTest::newRow("at it, idle") << 11.5 << std::size_t(1000) << false << false;
        QTest::newRow("a count above, idle") << 11.501 << std::size_t(3) << false << true;
        QTest::newRow("two samples, idle") << 500.0 << std::size_t(2) << false << false;
        QTest::newRow("at it, moving") << 1.5 << std::size_t(100) << true << false;
        QTest::newRow("a count above, moving") << 1.501 << std::size_t(3) << true << true;
        QTest::newRow("two samples, moving") << 500.0 << std::size_t(2) << true << false;
    }
    void aMeasuredForceBeyondTheThresholdStopsIt()
    {
        QFETCH(double, load_N);
        QFETCH(std::size_t, samples);
        QFETCH(bool, moves);
        QFETCH(bool, stops);
        BareDevice device(quiet());
        device.send(SetLimitsCommand{10000, ownTravel});
        moves ? moving(device) : armed(device);
        weight(device, load_N);
        device.run(samples);
        weight(device, 0);
        device.run(10);
        const int left = moves ? StatusArmed | StatusMoving : StatusArmed;
        QCOMPARE(int(device.lastStatus()), stops ? int(StatusForceLimit) : left);
    }

    void theTravelBeginsAtTheFirstMovingSample_data()
    {
        QTest::addColumn<int>("room"); // counts between the travel and the limit
        QTest::newRow("to the limit") << 0;
        QTest::newRow("beyond it") << -1;
    }
    void theTravelBeginsAtTheFirstMovingSample()
    {
        QFETCH(int, room);
        const auto squeezed = [](std::int32_t maxTravel) {
            BareDevice device(quiet(u"0.04,60,10000"_s)); // 10 N: 1 mm, at 12 mm from the encoder's zero
            device.send(SetLimitsCommand{10000, maxTravel});
            resting(device);
            device.run(1000);
            return device;
        };
        const BareDevice free = squeezed(ownTravel);
        std::int32_t most = 0, first = 0;
        for (const auto& [sample, status] : samplesOf(free)) {
            if (!(status & StatusMoving))
                continue;
            first = first == 0 ? sample.position : first;
            most = std::max(most, sample.position - first);
        }
        QVERIFY(most > 20 && most < 100);
        QCOMPARE(int(squeezed(most + room).lastStatus()),
                 room < 0 ? int(StatusTravelLimit) : int(StatusArmed));
    }

    void aShortFaultIsShownFor20ms()
    {
        BareDevice device(quiet());
        moving(device);
        broken(device);
        broken(device, false);
        device.stream.clear();
        device.run(device.firmware.samplesIn(VirtualFirmware::faultShown_s) - 1);
        QCOMPARE(int(device.lastStatus()), int(StatusFault));
        QVERIFY(device.send(ArmCommand{2}).result == CommandResult::Fault);
        device.run(3);
        QCOMPARE(int(device.lastStatus()), 0);
        QVERIFY(device.send(ArmCommand{2}).result ==
                CommandResult::Done); // one that was refused is not remembered
    }

    void anyMinorVersionIsObeyed_data()
    {
        QTest::addColumn<int>("minor");
        for (const int minor : {0, 1, 15})
            QTest::addRow("1.%d", minor) << minor;
    }
    void anyMinorVersionIsObeyed()
    {
        QFETCH(int, minor);
        for (const std::uint8_t own : {0, 1}) {
            VirtualFirmwareOptions options = quiet();
            options.protocolMinor = own;
            BareDevice device(options);
            armed(device);
            Report stop = encode(Command{9, StopCommand{}});
            seal(stop, static_cast<std::uint8_t>(minor));
            device.firmware.receive(stop, device.now_us);
            const auto answered = decodeInput(device.firmware.outbox().back());
            QVERIFY(std::get<Acknowledgement>(*answered).result == CommandResult::Done);
            QCOMPARE(int(std::get<Acknowledgement>(*answered).status), 0);
        }
    }
};

GRIPSCOPE_TEST(FirmwareRulesTest)
#include "firmware_rules_test.moc"
