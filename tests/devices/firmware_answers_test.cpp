// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/device_steps.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace gripscope::test;

// The table of what each command checks (devices/PROTOCOL.md, 3.4), a row each, held against the virtual
// device.

namespace {

void answer(const char* name, Steps before, CommandBody command, CommandResult result,
            std::uint32_t detail = 0)
{
    QTest::newRow(name) << before << command << static_cast<int>(result) << detail;
}

} // namespace

class FirmwareAnswersTest : public QObject {
    Q_OBJECT
private slots:
    void eachCommandIsAnsweredByItsFirstCheckThatFails_data()
    {
        QTest::addColumn<Steps>("before");
        QTest::addColumn<CommandBody>("command");
        QTest::addColumn<int>("result");
        QTest::addColumn<std::uint32_t>("detail");
        using R = CommandResult;
        const Steps nothing = [](BareDevice&) {};
        const auto started = [](std::uint16_t number) {
            return StartCommand{number, static_cast<std::uint32_t>(push.size()), forcesCrc(push)};
        };

        answer("Arm", nothing, ArmCommand{1}, R::Done, 0);
        answer("Arm tells the last start", finished, ArmCommand{2}, R::Repeated, 5);
        answer("Arm with its token again", armed, ArmCommand{1}, R::Repeated);
        answer(
            "Arm in a fault", [](BareDevice& d) { broken(d); }, ArmCommand{1}, R::Fault, 1);
        answer(
            "Arm with its token again, in a fault", [](BareDevice& d) { armed(d), broken(d); }, ArmCommand{1},
            R::Repeated);
        answer("Heartbeat, disarmed", nothing, HeartbeatCommand{}, R::Done);
        answer("Stop, disarmed", nothing, StopCommand{}, R::Repeated);
        answer("Stop, armed", armed, StopCommand{}, R::Done);
        answer(
            "Disarm, disarmed, with an upload", [](BareDevice& d) { d.upload(push, 5); }, DisarmCommand{},
            R::Done);
        answer(
            "Disarm, stopped", [](BareDevice& d) { moving(d), d.send(StopCommand{}); }, DisarmCommand{},
            R::Repeated);

        answer("limits of nothing while it runs", moving, SetLimitsCommand{0, 0}, R::BadValue, 1);
        answer("travel of nothing", nothing, SetLimitsCommand{1, 0}, R::BadValue, 2);
        answer("limits while it rests before", resting, SetLimitsCommand{1, 1}, R::Busy);
        answer("limits while it settles", settling, SetLimitsCommand{1, 1}, R::Done);
        answer("force and travel above the own", nothing, SetLimitsCommand{ownForce + 1, ownTravel + 1},
               R::LimitExceeded, 1);
        answer("travel above the own", nothing, SetLimitsCommand{ownForce, ownTravel + 1}, R::LimitExceeded,
               2);
        answer("the own limits", nothing, SetLimitsCommand{ownForce, ownTravel}, R::Done);

        answer("Upload while it moves", moving, chunk(6, 0, {1}), R::Busy);
        answer("Upload while it settles", settling, chunk(6, 0, {1}), R::Done);
        answer("Upload with the number of the last start", finished, chunk(5, 0, {1}), R::Spent, 5);
        answer("Upload with a number far behind", finished, chunk(0x8005, 0, {1}), R::Spent, 5);
        answer("Upload with the farthest number ahead", finished, chunk(0x8004, 0, {1}), R::Done);
        answer("Upload 0 before any start", nothing, chunk(0, 0, {1}), R::Spent, 0);
        answer("Upload beyond the memory", nothing, chunk(1, mostSamples - 1, {1, -1}), R::BadValue,
               mostSamples);
        answer("Upload far beyond", nothing, chunk(1, 0xFFFFFFFF, {1, 1}), R::BadValue, 0xFFFFFFFF);
        answer("Upload to the last index", nothing, chunk(1, mostSamples - 2, {1, 1}), R::Done);
        answer("Upload above, then below", nothing, chunk(1, 24, {0, ownForce + 1, -1}), R::LimitExceeded,
               25);
        answer("Upload below, then above", nothing, chunk(1, 24, {-1, ownForce + 1}), R::BadValue, 24);
        answer("Upload of the limit itself", nothing, chunk(1, 0, {ownForce}), R::Done);

        answer(
            "Start again, though disarmed", [](BareDevice& d) { finished(d), d.send(StopCommand{}); },
            started(5), R::Repeated);
        answer("Start again while it runs", moving, started(5), R::Repeated);
        answer(
            "Start, disarmed", [](BareDevice& d) { d.upload(push, 5); }, started(5), R::NotArmed);
        answer("Start another while it runs", moving, started(4), R::Busy);
        answer("Start an older one", finished, started(4), R::Spent, 5);
        answer("Start nothing", loaded, StartCommand{5, 0, forcesCrc({})}, R::BadValue);
        answer("Start more than it can hold", loaded, StartCommand{5, mostSamples + 1, 0}, R::BadValue);
        answer("Start another than was uploaded", loaded, started(6), R::Incomplete);
        answer(
            "Start with a force missing", [](BareDevice& d) { armed(d), d.send(chunk(5, 1, {1})); },
            StartCommand{5, 2, forcesCrc({0, 1})}, R::Incomplete, 0);
        answer("Start with the last one missing", loaded, StartCommand{5, 401, 0}, R::Incomplete, 400);
        answer("Start with one too many", loaded, StartCommand{5, 399, 0}, R::BadValue, 399);
        answer("Start with another CRC", loaded,
               StartCommand{5, 400, static_cast<std::uint16_t>(forcesCrc(push) + 1)}, R::ChecksumDiffers,
               forcesCrc(push));
        answer(
            "Start above limits lowered since",
            [](BareDevice& d) {
                loaded(d), d.send(SetLimitsCommand{9999, ownTravel});
            },
            started(5), R::LimitExceeded, 0);
        answer("Start", loaded, started(5), R::Done);

        answer("Finish another", moving, FinishCommand{4}, R::Repeated);
        answer("Finish while it settles", settling, FinishCommand{5}, R::Repeated);
        answer("Finish while it rests before", resting, FinishCommand{5}, R::Done);
        answer("Finish", moving, FinishCommand{5}, R::Done);
    }
    void eachCommandIsAnsweredByItsFirstCheckThatFails()
    {
        QFETCH(Steps, before);
        QFETCH(CommandBody, command);
        QFETCH(int, result);
        QFETCH(std::uint32_t, detail);
        BareDevice device;
        before(device);
        const Acknowledgement found = device.send(command);
        QCOMPARE(static_cast<int>(found.result), result);
        QCOMPARE(found.detail, detail);
    }
};

GRIPSCOPE_TEST(FirmwareAnswersTest)
#include "firmware_answers_test.moc"
