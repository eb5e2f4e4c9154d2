// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/device_button.h"
#include "tests/devices/bare_device.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

// The device itself, by its bytes alone: what protects a hand must hold whatever a program sends.

namespace {

using Device = BareDevice;
const std::vector<std::int32_t> push(200, 10000); // 10 N for 100 ms

} // namespace

class VirtualFirmwareTest : public QObject {
    Q_OBJECT
private slots:
    void aFaultStopsItAndKeepsItFromArming()
    {
        Device device;
        const std::vector<std::int32_t> forces(1000, 20000);
        QCOMPARE(device.send(ArmCommand{}).result, CommandResult::Done);
        QCOMPARE(device.upload(forces, 1), CommandResult::Done);
        QCOMPARE(device.start(forces, 1), CommandResult::Done);
        device.run(300);
        QVERIFY(device.lastStatus() & StatusMoving);
        FirmwareFaults faults;
        faults.broken = true;
        device.firmware.setFaults(faults);
        const std::size_t pushed = device.pushedSamples();
        device.run(300);
        QCOMPARE(device.pushedSamples(), pushed);
        QVERIFY(device.lastStatus() & StatusFault);
        QVERIFY(!(device.lastStatus() & StatusArmed));
        QCOMPARE(device.send(ArmCommand{}).result, CommandResult::Fault);
        device.firmware.setFaults({});
        QCOMPARE(device.send(ArmCommand{}).result, CommandResult::Done);
    }

    void itsButtonIsShownAndDoesNothingByItself()
    {
        Device device;
        QCOMPARE(device.send(ArmCommand{}).result, CommandResult::Done);
        QCOMPARE(device.upload(push, 1), CommandResult::Done);
        FirmwareFaults person;
        person.buttonDown = true;
        device.run(100);
        QVERIFY(!(device.lastStatus() & statusButton));
        device.firmware.setFaults(person);
        device.run(100);
        QVERIFY(device.lastStatus() & statusButton);
        QVERIFY(device.lastStatus() & StatusArmed);
        device.firmware.setFaults({});
        device.run(100);
        QVERIFY(!(device.lastStatus() & statusButton));
        QCOMPARE(device.pushedSamples(), std::size_t(0));
    }

    void nothingMovesItBeforeItIsArmed()
    {
        Device device;
        QCOMPARE(device.upload(push, 1), CommandResult::Done);
        QCOMPARE(device.start(push, 1), CommandResult::NotArmed);
        device.run(1000);
        QCOMPARE(device.pushedSamples(), std::size_t(0));
    }

    void runsWhatWasUploadedAndStaysArmed()
    {
        Device device;
        device.send(ArmCommand{});
        QCOMPARE(device.upload(push, 1), CommandResult::Done);
        QCOMPARE(device.start(push, 1), CommandResult::Done);
        device.run(1000);
        QCOMPARE(device.pushedSamples(), push.size());
        QVERIFY(device.stream.back().excitation == ExcitationState::Finished);
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusArmed));
    }

    void stopsWhenNoHeartbeatComesFor100ms()
    {
        Device device;
        device.send(ArmCommand{});
        const std::vector<std::int32_t> longPush(400, 10000);
        device.upload(longPush, 1);
        device.start(longPush, 1);
        device.run(150); // 75 ms: 50 of rest, 25 of force
        QVERIFY(device.lastStatus() & StatusMoving);
        device.stream.clear();
        device.run(1000, false);
        // The last heartbeat came 49 samples before; 100 ms are 200 samples.
        QCOMPARE(device.pushedSamples(), std::size_t(151));
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusWatchdog));
        QVERIFY(device.stream.back().excitation == ExcitationState::Stopped);
        device.send(ArmCommand{});
        device.run(10);
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusArmed)); // the bit stays until then
    }

    void armedButIdleItDisarmsWithoutHeartbeats()
    {
        Device device;
        device.send(ArmCommand{});
        device.run(190, false);
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusArmed));
        device.run(20, false);
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusWatchdog));
    }

    /// For tests beside busy processes: it still proves its watchdog, and bears late heartbeats from then on.
    void aPatientOneTripsAtOnceOnlyOnce()
    {
        VirtualFirmwareOptions options = BareDevice::options(u"A"_qs);
        options.patience_ms = 1000;
        Device device(options);
        device.send(ArmCommand{});
        device.run(210, false); // 105 ms
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusWatchdog));
        device.send(ArmCommand{});
        device.run(2190, false); // 1,095 ms
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusArmed));
        device.run(20, false);
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusWatchdog));
    }

    void stopTakesTheForceOffWithTheNextSample()
    {
        Device device;
        device.send(ArmCommand{});
        device.upload(push, 1);
        device.start(push, 1);
        device.run(150);
        device.stream.clear();
        QCOMPARE(device.send(StopCommand{}).status & (StatusArmed | StatusMoving), 0);
        device.stream.clear();
        device.run(500);
        QCOMPARE(device.pushedSamples(), std::size_t(0));
        QVERIFY(device.stream.back().excitation == ExcitationState::Stopped);
        QCOMPARE(device.start(push, 1), CommandResult::Repeated); // and nothing starts
        device.run(500);
        QCOMPARE(device.pushedSamples(), std::size_t(0));
    }

    void finishEndsASqueezeInGoodOrderAndStaysArmed()
    {
        Device device;
        device.send(ArmCommand{});
        const std::vector<std::int32_t> longPush(400, 10000);
        device.upload(longPush, 1);
        device.start(longPush, 1);
        device.run(150);                                                          // 50 of force
        QVERIFY(device.send(FinishCommand{2}).result == CommandResult::Repeated); // another's
        QVERIFY(device.lastStatus() & StatusMoving);
        QVERIFY(device.send(FinishCommand{1}).result == CommandResult::Done);
        QVERIFY(device.send(FinishCommand{1}).result == CommandResult::Repeated);
        device.run(500);
        QCOMPARE(device.pushedSamples(), std::size_t(50));
        QCOMPARE(device.lastStatus(), std::uint16_t(StatusArmed));
        QVERIFY(device.stream.back().excitation == ExcitationState::Finished);
        QCOMPARE(device.upload(push, 2), CommandResult::Done);
        QCOMPARE(device.start(push, 2), CommandResult::Done); // the next one needs no arming
    }

    void repeatedCommandsDoNoHarm()
    {
        Device device;
        const Command arm{1, ArmCommand{}};
        QVERIFY(device.send(arm).result == CommandResult::Done);
        QVERIFY(device.send(arm).result == CommandResult::Repeated);
        for (int time = 0; time < 2; ++time)
            QCOMPARE(device.upload(push, 1), CommandResult::Done);
        QCOMPARE(device.start(push, 1), CommandResult::Done);
        for (int time = 0; time < 5; ++time) {
            device.run(200);
            QCOMPARE(device.start(push, 1), CommandResult::Repeated); // while it runs and after
        }
        device.run(2000);
        QCOMPARE(device.pushedSamples(), push.size());
        QCOMPARE(device.firmware.squeezesStarted(), std::uint64_t(1));
        // A late upload of the same excitation can not be started either.
        QCOMPARE(device.upload(push, 1), CommandResult::Spent);
        for (int time = 0; time < 3; ++time)
            device.send(StopCommand{});
        QCOMPARE(device.send(ArmCommand{}).detail, 1U);
    }

    void refusesForcesAboveItsLimit()
    {
        Device device;
        device.send(ArmCommand{});
        QCOMPARE(device.upload({100000, 100001}, 1), CommandResult::LimitExceeded); // 100 N is its own
        QVERIFY(device.send(SetLimitsCommand{20000, 500}).result == CommandResult::Done);
        QCOMPARE(device.upload({20001}, 1), CommandResult::LimitExceeded);
        QCOMPARE(device.upload({20000}, 1), CommandResult::Done);
    }

    void refusesLimitsAboveItsOwn()
    {
        Device device;
        QVERIFY(device.send(SetLimitsCommand{100001, 100}).result == CommandResult::LimitExceeded);
        QVERIFY(device.send(SetLimitsCommand{1000, 1251}).result == CommandResult::LimitExceeded);
        QVERIFY(device.send(SetLimitsCommand{0, 100}).result == CommandResult::BadValue);
        QVERIFY(device.send(SetLimitsCommand{1000, -1}).result == CommandResult::BadValue);
    }

    void refusesAtStartWhatBecameTooMuchSinceTheUpload()
    {
        Device device;
        device.send(ArmCommand{});
        device.upload(push, 1);
        device.send(SetLimitsCommand{9999, 500});
        QCOMPARE(device.start(push, 1), CommandResult::LimitExceeded);
        device.run(1000);
        QCOMPARE(device.pushedSamples(), std::size_t(0));
    }

    void refusesToPull()
    {
        Device device;
        device.send(ArmCommand{});
        QCOMPARE(device.upload({-1}, 1), CommandResult::BadValue);
    }

    void stopsAtTheTravelLimit()
    {
        Device device(u"0.04,5,400"_qs); // 10 N move it by 25 mm and, hardly damped, on beyond
        device.send(ArmCommand{});
        device.send(SetLimitsCommand{10000, 100}); // 2 mm
        device.upload(push, 1);
        device.start(push, 1);
        device.run(1000);
        QVERIFY(device.pushedSamples() > 0);
        QVERIFY(device.pushedSamples() < push.size());
        QVERIFY(device.lastStatus() & StatusTravelLimit);
        QVERIFY(!(device.lastStatus() & StatusArmed));
        QVERIFY(device.stream.back().excitation == ExcitationState::Stopped);
    }

    void startsOnlyWhatIsWhole()
    {
        Device device;
        device.send(ArmCommand{});
        QCOMPARE(device.start(push, 1), CommandResult::Incomplete);
        device.upload(push, 1);
        std::vector<std::int32_t> longer = push;
        longer.push_back(0);
        QCOMPARE(device.start(longer, 1), CommandResult::Incomplete);
        std::vector<std::int32_t> other = push;
        other[7] = 1;
        QCOMPARE(device.start(other, 1), CommandResult::ChecksumDiffers);
        const std::vector<std::int32_t> shorter(push.begin(), push.end() - 1);
        QCOMPARE(device.start(shorter, 1), CommandResult::BadValue);
        QCOMPARE(device.start(push, 2), CommandResult::Incomplete);
        device.run(500);
        QCOMPARE(device.pushedSamples(), std::size_t(0));
    }

    void refusesUploadsWhileItRuns()
    {
        Device device;
        device.send(ArmCommand{});
        device.upload(push, 1);
        device.start(push, 1);
        device.run(150);
        QCOMPARE(device.upload(push, 2), CommandResult::Busy);
        QVERIFY(device.send(SetLimitsCommand{100, 100}).result == CommandResult::Busy);
    }

    void refusesUploadsBeyondItsMemory()
    {
        Device device;
        UploadCommand chunk{1, VirtualFirmware::maxSamples - 1, 2, {}};
        QVERIFY(device.send(chunk).result == CommandResult::BadValue);
        chunk.offset = 0xFFFFFFFF;
        QVERIFY(device.send(chunk).result == CommandResult::BadValue);
        chunk.offset = VirtualFirmware::maxSamples - 2;
        QVERIFY(device.send(chunk).result == CommandResult::Done);
    }

    void answersWhatItDoesNotKnowAndIgnoresWhatIsDamaged()
    {
        Device device;
        Report unknown = encode(Command{77, HeartbeatCommand{}});
        unknown[0] = 0x2F;
        seal(unknown);
        device.firmware.receive(unknown, 0);
        QCOMPARE(device.firmware.outbox().size(), std::size_t(1));
        const auto answer = std::get<Acknowledgement>(*decodeInput(device.firmware.outbox().front()));
        QVERIFY(answer.result == CommandResult::UnknownCommand);
        QCOMPARE(answer.commandNumber, std::uint16_t(77));

        device.firmware.outbox().clear();
        Report damaged = encode(Command{78, ArmCommand{}});
        damaged[5] ^= 4;
        device.firmware.receive(damaged, 0);
        const Report whole = encode(Command{79, ArmCommand{}});
        device.firmware.receive(ReportView(whole).first(63), 0);
        QVERIFY(device.firmware.outbox().empty());
    }
};

GRIPSCOPE_TEST(VirtualFirmwareTest)
#include "virtual_firmware_test.moc"
