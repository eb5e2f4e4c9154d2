// SPDX-License-Identifier: GPL-3.0-or-later
// hidapi itself and libudev itself, on device nodes that umockdev makes: found, opened, streamed from,
// commanded, unplugged, plugged in again, forbidden.
#include "devices/hid/hid_watcher.h"
#include "tests/devices/connected_program.h"
#include "tests/devices/umockdev/mocked_system.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using State = ConnectSession::State;

namespace {

const QString address = u"hid:1209:0001:VG-7"_qs;

/// A program beside the grippers that it may connect to.
struct Bench {
    MockedSystem system;
    std::vector<std::unique_ptr<MockedGripper>> grippers; ///< the last one is the one that is spoken with
    ConnectedProgram program;

    Bench()
    {
        // The device is driven by this same thread, and a busy computer keeps both waiting.
        program.factory.setLinkLimits(patientLimits());
        program.alsoDrive = [this] {
            if (!grippers.empty())
                grippers.back()->turn(program.connection.counters().reports);
        };
    }
    MockedGripper& plugIn(int number, std::uint64_t seed)
    {
        grippers.push_back(std::make_unique<MockedGripper>(system, number, seed));
        return *grippers.back();
    }
    void unplug() { grippers.back()->unplug(); }
    /// On a busy computer the terminal may still run two reports together, which make one that is bad;
    /// nothing else may be missing.
    [[nodiscard]] bool lostNothing() const
    {
        const LinkCounters counters = program.connection.counters();
        return counters.lostSamples <= 2 * protocol::maxSamplesPerReport * counters.badReports &&
               counters.badReports <= 3 && counters.duplicateReports == 0;
    }
};

} // namespace

class HidHotplugTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        const MockedSystem system;
        QVERIFY2(umockdev_in_mock_environment(),
                 "umockdev's library is not loaded: start this with umockdev-wrapper");
    }

    void aGripperIsFoundOpenedAndStreamsWithoutLoss()
    {
        Bench bench;
        bench.plugIn(0, 7);
        QCOMPARE(findDevices().back().address, address);
        QVERIFY(bench.program.connectTo(u"hid:"_qs));
        QCOMPARE(bench.program.connection.identity().serial, u"VG-7"_qs);
        QCOMPARE(bench.program.connection.identity().address, address);
        QVERIFY(bench.program.untilSamples(300));
        QVERIFY(bench.lostNothing());
    }

    void commandsArriveAndAreAnswered()
    {
        Bench bench;
        bench.plugIn(0, 7);
        QVERIFY(bench.program.connectTo(address));
        QVERIFY2(bench.program.arm(), qPrintable(bench.program.whatHolds()));
        QVERIFY(bench.program.squeeze(0.05));
        QCOMPARE(bench.program.job.state(), SqueezeJob::State::Done);
        QVERIFY(bench.program.job.recording().size() >= 100);
        QVERIFY(bench.lostNothing());
    }

    void unpluggedAndPluggedInAgainItGoesOnByItself()
    {
        Bench bench;
        bench.plugIn(0, 7);
        QVERIFY(bench.program.connectTo(u"hid:"_qs));
        QVERIFY2(bench.program.arm(), qPrintable(bench.program.whatHolds()));
        QVERIFY(bench.program.untilSamples(20));
        bench.unplug();
        QVERIFY(bench.program.untilState(State::Lost));
        QVERIFY(bench.program.connection.awaiting());
        const std::uint64_t before = bench.program.connection.counters().samples;
        bench.plugIn(1, 7); // the old node's handle is still open
        QVERIFY(bench.program.untilState(State::Connected));
        QVERIFY(bench.program.untilSamples(20));
        QVERIFY(bench.program.connection.counters().samples > before);
        QCOMPARE(bench.program.connection.reconnections(), 1);
        QCOMPARE(bench.program.connection.address(), u"hid:"_qs);
        QVERIFY(!bench.program.connection.armed());
        QVERIFY(bench.lostNothing());
    }

    void anotherGripperIsNotConnectedInItsPlace()
    {
        Bench bench;
        bench.plugIn(0, 7);
        QVERIFY(bench.program.connectTo(u"hid:"_qs));
        bench.unplug();
        QVERIFY(bench.program.untilState(State::Lost));
        bench.plugIn(1, 8);
        bench.plugIn(2, 7);
        QVERIFY(bench.program.untilState(State::Connected)); // had it taken the other, it would be that one
        QCOMPARE(bench.program.connection.identity().serial, u"VG-7"_qs);
    }

    void oneThatIsPluggedInLaterIsConnectedThen()
    {
        Bench bench;
        QVERIFY(bench.program.connection.connectTo(u"hid:"_qs).has_value());
        QVERIFY(bench.program.untilState(State::Lost));
        QCOMPARE(bench.program.connection.lastError()->code, ErrorCode::DeviceNotFound);
        QVERIFY(bench.program.connection.awaiting());
        bench.plugIn(0, 9);
        QVERIFY(bench.program.untilState(State::Connected));
        QCOMPARE(bench.program.connection.identity().serial, u"VG-9"_qs);
    }

    void ofTwoTheOneThatIsNamed()
    {
        Bench bench;
        bench.plugIn(0, 8);
        bench.plugIn(1, 7);
        QVERIFY(bench.program.connection.connectTo(u"hid:"_qs).has_value());
        QVERIFY(bench.program.untilState(State::Lost));
        const Error error = *bench.program.connection.lastError();
        QCOMPARE(error.code, ErrorCode::DeviceAmbiguous);
        QVERIFY(error.describe().contains(u"hid:1209:0001:VG-8, hid:1209:0001:VG-7"_qs));
        QVERIFY(!bench.program.connection.awaiting());
        QVERIFY(bench.program.connectTo(address));
        QVERIFY(bench.program.untilSamples(20));
        QCOMPARE(bench.program.connection.identity().serial, u"VG-7"_qs);
    }

    void withoutPermissionItSaysWhatToTypeAndConnectsOnceThatIsDone()
    {
        Bench bench;
        MockedGripper& gripper = bench.plugIn(0, 7);
        gripper.setMode(0000);
        const Unprivileged person;
        QVERIFY(bench.program.connection.connectTo(address).has_value());
        QVERIFY(bench.program.untilState(State::Lost));
        const Error error = *bench.program.connection.lastError();
        QCOMPARE(error.code, ErrorCode::DevicePermission);
        QVERIFY2(error.describe().contains(u"reading and writing"_qs), qPrintable(error.describe()));
        QVERIFY(error.describe().contains(u"sudo "_qs)); // which line depends on the rules that are here
        QVERIFY(bench.program.connection.awaiting());
        gripper.setMode(0600);
        QVERIFY(bench.program.untilState(State::Connected));
        QVERIFY(bench.program.untilSamples(20));
    }

    void theWatcherTellsOfArrivalPermissionAndRemoval()
    {
        MockedSystem system;
        const HidWatcher watcher;
        QVERIFY(waitFor([&] { return watcher.revision() == 1; }));
        QVERIFY(watcher.snapshot().nodes.empty());
        MockedGripper gripper(system, 3, 7);
        QVERIFY(waitFor([&] { return !watcher.snapshot().nodes.empty(); }));
        const HidNode node = watcher.snapshot().nodes.front();
        QCOMPARE(node.path, u"/dev/hidraw3"_qs);
        QCOMPARE(node.serial, u"VG-7"_qs);
        QCOMPARE(node.port, u"usb-mock-VG-7/input0"_qs);
        QCOMPARE(node.instance, u"hidraw3/0003:1209:0001.0003"_qs);
        QVERIFY(node.vendorPage);
        QVERIFY(node.accessible);
        {
            const Unprivileged person;
            gripper.setMode(0000);
            QVERIFY(waitFor([&] { return !watcher.snapshot().nodes.front().accessible; }));
        }
        gripper.unplug();
        QVERIFY(waitFor([&] { return watcher.snapshot().nodes.empty(); }));
    }

    void aWatcherMayComeAndGoAtAnyTime()
    {
        MockedSystem system;
        const auto threads = [] { return QDir(u"/proc/self/task"_qs).entryList(QDir::AllDirs).size(); };
        qsizetype alone = 0;
        QTest::qWait(500); // the watcher of the test before ends
        for (int i = 0; i < 20; ++i) {
            {
                const HidWatcher watcher;
                const MockedGripper gripper(system, i, 7);
                if (i % 2 == 0)
                    QVERIFY(waitFor([&] { return watcher.snapshot().nodes.size() == 1; }));
            }
            if (i == 0) {
                QTest::qWait(500); // the mock's own threads have begun, the watcher's has ended
                alone = threads();
            }
            // On a busy machine a watcher's thread may end after it. The mock aborts when whom it tells of
            // the next gripper goes away meanwhile.
            QVERIFY(waitFor([&] { return threads() <= alone; }));
        }
    }
};

GRIPSCOPE_TEST(HidHotplugTest)
#include "hid_hotplug_test.moc"
