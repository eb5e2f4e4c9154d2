// SPDX-License-Identifier: GPL-3.0-or-later
// Another maker's gripper as the sessions see it: found by its profile, listened to, never written to.
#include "core/identification/identification.h"
#include "core/session/connection/connect_session.h"
#include "core/session/squeeze/squeeze_job.h"
#include "core/signal/recording/units.h"
#include "devices/acquisition/device_port.h"
#include "devices/profile/profiled_device.h"
#include "devices/profile/report_watch.h"
#include "devices/profile/virtual_robot_transport.h"
#include "devices/replay/captured_session.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// A robot that counts what is written to it.
class CountingTransport : public VirtualRobotTransport {
public:
    using VirtualRobotTransport::VirtualRobotTransport;
    bool write(const protocol::Report&) override
    {
        ++writes;
        return true;
    }
    Expected<protocol::Report> feature(protocol::ReportId id) override
    {
        ++writes;
        return VirtualRobotTransport::feature(id);
    }
    std::atomic<int> writes{0};
};

VirtualAddress addressOf(const QString& text)
{
    return std::get<VirtualAddress>(parseDeviceAddress(text).value());
}

/// The whole stream of a virtual robot at speed 0.
std::vector<Sample> streamOf(OpenPort& gripper)
{
    if (!gripper.pollUntil([&] { return gripper.port->state() == LinkState::Closed; }))
        return {};
    gripper.port->drain(gripper.samples);
    return gripper.samples;
}

/// One recording of `seconds` from `address`.
Recording listenTo(const QString& address, double seconds)
{
    DeviceFactory factory;
    ConnectSession connection(factory);
    SqueezeJob job(connection);
    if (!connection.connectTo(address) || !waitFor([&] {
            connection.poll();
            return connection.state() == ConnectSession::State::Connected;
        }))
        return {};
    if (!job.listen(seconds) || !waitFor([&] {
            connection.poll();
            job.poll();
            return job.state() == SqueezeJob::State::Done || job.state() == SqueezeJob::State::Failed;
        }))
        return {};
    return job.recording();
}

} // namespace

class ProfilePortTest : public QObject {
    Q_OBJECT
private slots:
    void theExamplesStreamAndAreNotCommandable_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("lossVisible");
        QTest::addColumn<double>("sampleTime_s");
        QTest::newRow("big endian") << u"example_big_endian"_s << true << 0.002;
        QTest::newRow("float stream") << u"example_float_stream"_s << true << 0.0005;
        QTest::newRow("bare") << u"example_bare"_s << false << 0.004;
    }
    void theExamplesStreamAndAreNotCommandable()
    {
        QFETCH(QString, name);
        QFETCH(bool, lossVisible);
        QFETCH(double, sampleTime_s);
        OpenPort gripper(u"virtual:?speed=0&profile="_s + name);
        QVERIFY(!streamOf(gripper).empty());
        const GripperIdentity identity = gripper.port->identity();
        QVERIFY(!identity.commandable);
        QCOMPARE(identity.lossVisible, lossVisible);
        QCOMPARE(identity.sampleTime_s, sampleTime_s);
        QCOMPARE(identity.serial, u"VR-1"_s);
        QCOMPARE(gripper.samples.size(), std::size_t(VirtualRobotTransport::samplesAtSpeedZero));
        QCOMPARE(gripper.port->counters().lostSamples, std::uint64_t(0));
        QVERIFY(!gripper.gate.arm(u"tester"_s));
    }
    void nothingIsEverWrittenToIt()
    {
        const auto robot = std::make_shared<CountingTransport>(
            addressOf(u"virtual:?profile=example_bare"_s), [] { return namedProfile(u"example_bare"_s); });
        const ProfiledDeviceMakers makers = *profiledDevice(addressOf(u"virtual:?profile=example_bare"_s));
        OpenPort gripper(std::make_unique<DevicePort>(
            u"virtual:"_s, [robot] { return robot; }, SampleQueue::defaultCapacity, makers.decoder));
        QVERIFY(gripper.ready());
        QVERIFY(!gripper.arm());
        gripper.port->disarm();
        gripper.port->finishExcitation();
        gripper.port->stop();
        QVERIFY(gripper.pollUntil([&] { return gripper.samples.size() > 100; }));
        gripper.port->stop();
        gripper.port->close();
        QCOMPARE(robot->writes.load(), 0);
    }
    void lostReportsAreCountedBySequenceAndByClock_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("sequence") << u"example_big_endian"_s;
        QTest::newRow("clock") << u"example_float_stream"_s;
        QTest::newRow("both") << u"walkthrough"_s;
    }
    void lostReportsAreCountedBySequenceAndByClock()
    {
        QFETCH(QString, name);
        OpenPort gripper(u"virtual:?speed=0&fault=loss:0.05,duplicate:0.02&profile="_s + name);
        const std::vector<Sample> samples = streamOf(gripper);
        QVERIFY(!samples.empty());
        const LinkCounters counters = gripper.port->counters();
        QVERIFY(counters.lostSamples > 2000);
        QVERIFY(counters.duplicateReports > 100);
        QCOMPARE(samples.back().sequence - samples.front().sequence + 1,
                 samples.size() + counters.lostSamples);
        QCOMPARE(counters.badReports, std::uint64_t(0));
    }
    void theSamplesOfASeedAreAlwaysTheSame()
    {
        OpenPort one(u"virtual:?speed=0&seed=5&profile=example_bare"_s);
        OpenPort two(u"virtual:?speed=0&seed=5&profile=example_bare"_s);
        const std::vector<Sample> first = streamOf(one), second = streamOf(two);
        QVERIFY(!first.empty() && first.size() == second.size());
        for (std::size_t i = 0; i < first.size(); ++i)
            QVERIFY(first[i].force == second[i].force && first[i].position == second[i].position);
    }
    void anUnpluggedOneIsLostAndASilentOneIsLostAfterASecond()
    {
        OpenPort unplugged(u"virtual:?fault=unplug:0.1&profile=example_bare"_s);
        QVERIFY(unplugged.pollUntil([&] { return unplugged.port->state() == LinkState::Lost; }));
        OpenPort silent(u"virtual:?fault=stall:0.1&profile=example_bare"_s);
        QVERIFY(silent.pollUntil([&] { return silent.port->state() == LinkState::Lost; }));
    }
    void theStiffnessOfTheCanIsFoundByListening_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("500 a second") << u"example_big_endian"_s;
        QTest::newRow("2000 a second") << u"example_float_stream"_s;
        QTest::newRow("1000 a second") << u"walkthrough"_s;
    }
    void theStiffnessOfTheCanIsFoundByListening()
    {
        QFETCH(QString, name);
        const Recording recording = listenTo(u"virtual:?speed=0&seed=3&profile="_s + name, 3);
        QVERIFY(recording.size() > 1000);
        const Identification found = identify(recording);
        const Estimate* best = found.best();
        QVERIFY(best != nullptr);
        const MassDampingStiffness truth = VirtualObject::fromText(u"A"_s)->draw(3, 0);
        const double si = siFactor(recording.forceUnit, recording.positionUnit).value();
        const double k = best->parameters->k * si;
        QVERIFY2(std::abs(k - truth.k) < 0.02 * truth.k, qPrintable(u"%1 %2"_s.arg(k).arg(truth.k)));
    }
    void aRecordingSaysThatItsLossesCannotBeSeen()
    {
        const Recording blind = listenTo(u"virtual:?speed=0&fault=loss:0.05&profile=example_bare"_s, 1);
        QVERIFY(blind.provenance[u"losses"_s].startsWith(u"cannot be seen"_s));
        for (const ValidityCheck& check : identify(blind).validity.checks)
            QVERIFY(check.id != u"samples_lost" || check.message.describe().contains(u"cannot be seen"));
        const Recording seen = listenTo(u"virtual:?speed=0&profile=walkthrough"_s, 1);
        QVERIFY(seen.size() > 0 && !seen.provenance.contains(u"losses"_s));
    }
    void aKeptSessionIsReadByTheProfileItWasReadBy_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"example_big_endian", "example_float_stream", "example_bare"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void aKeptSessionIsReadByTheProfileItWasReadBy()
    {
        QFETCH(QString, name);
        const QTemporaryDir folder;
        const QString capture = folder.filePath(u"robot.gscap"_s);
        OpenPort live(u"virtual:?speed=0&fault=loss:0.02&profile=%1&capture=%2"_s.arg(name, capture));
        const std::vector<Sample> then = streamOf(live);
        const GripperIdentity identity = live.port->identity();
        live.port->close();
        OpenPort replay(u"replay:%1?speed=0"_s.arg(capture));
        QVERIFY(replay.pollUntil([&] { return replay.port->state() == LinkState::Closed; }));
        replay.port->drain(replay.samples);
        QCOMPARE(replay.port->identity().name, identity.name);
        QCOMPARE(replay.port->identity().serial, identity.serial);
        QVERIFY(then.size() > 100 && replay.samples.size() >= then.size());
        for (std::size_t i = 0; i < then.size(); ++i)
            QVERIFY(replay.samples[i].sequence == then[i].sequence &&
                    replay.samples[i].time_s == then[i].time_s && replay.samples[i].force == then[i].force &&
                    replay.samples[i].position == then[i].position);
        const Expected<CapturedSession> session = readCapturedSession(capture);
        QVERIFY(session && session->counters.samples == replay.samples.size());
        QCOMPARE(session->counters.lostSamples, replay.port->counters().lostSamples);
    }
    void aProfileIsFoundByTheUsbNumbersOfWhatIsSent()
    {
        const QTemporaryDir folder;
        qputenv("GRIPSCOPE_PROFILES", folder.path().toUtf8());
        const QString address = u"virtual:?speed=0&like=walkthrough"_s;
        OpenPort unknown(address);
        QVERIFY(unknown.pollUntil([&] { return unknown.port->state() == LinkState::Lost; }));
        QCOMPARE(unknown.port->lastError()->code, ErrorCode::NotFound);
        const GripperProfile profile = namedProfile(u"walkthrough"_s).value();
        QVERIFY(installProfile(writeProfile(profile)));
        OpenPort known(address);
        QVERIFY(!streamOf(known).empty());
        QCOMPARE(known.port->identity().name, profile.name);
        qunsetenv("GRIPSCOPE_PROFILES");
    }
    void anAddressNamesItsProfile()
    {
        const DeviceAddress hid = parseDeviceAddress(u"hid:1209:0002:X?profile=a.json&capture=b"_s).value();
        QCOMPARE(std::get<HidAddress>(hid).profile, u"a.json"_s);
        QCOMPARE(std::get<HidAddress>(hid).capture, u"b"_s);
        QVERIFY(profiledDevice(std::get<HidAddress>(hid)));
        QVERIFY(profiledDevice(std::get<HidAddress>(parseDeviceAddress(u"hid:1209:0002"_s).value())));
        QVERIFY(!profiledDevice(std::get<HidAddress>(parseDeviceAddress(u"hid:"_s).value())));
        QVERIFY(!profiledDevice(std::get<HidAddress>(parseDeviceAddress(u"hid:1209:0001:X"_s).value())));
        QVERIFY(!profiledDevice(addressOf(u"virtual:"_s)));
    }
    void bytesThatMoveAreToldFromThoseThatRest()
    {
        ReportWatch watch;
        watch.start(listenAt(u"virtual:?speed=0&like=walkthrough"_s).value());
        ReportWatch::Snapshot seen;
        QVERIFY(waitFor([&] {
            seen = watch.snapshot();
            return seen.state == ReportWatch::State::Ended;
        }));
        QCOMPARE(seen.kinds.size(), std::size_t(1));
        const ReportStatistics& reports = seen.kinds.begin()->second;
        QCOMPARE(reports.reports(), std::uint64_t(VirtualRobotTransport::samplesAtSpeedZero));
        QString moving;
        for (const ByteStatistics& byte : reports.bytes())
            moving += byte.moves() ? u'x' : u'.';
        // report ID, status, counter; clock, whose highest byte rests; force, position (the same); not used
        QCOMPARE(moving, u".xxx.xxxxx.xx..."_s);
        QCOMPARE(int(reports.bytes()[3].least), 0);
        QCOMPARE(int(reports.bytes()[3].most), 255);
    }
    void aWatchedReportIsReadByTheProfileAsSoonAsThereIsOne()
    {
        ReportWatch watch;
        watch.start(listenAt(u"virtual:?like=walkthrough"_s).value());
        QVERIFY(waitFor([&] { return !watch.snapshot().kinds.empty(); }));
        watch.use(namedProfile(u"walkthrough"_s).value());
        ReportWatch::Snapshot seen;
        QVERIFY(waitFor([&] {
            seen = watch.snapshot();
            return seen.samples > 50;
        }));
        QCOMPARE(seen.badReports, std::uint64_t(0));
        QVERIFY(seen.newest.id == std::uint8_t(7));
        watch.use(std::nullopt);
        QCOMPARE(watch.snapshot().samples, std::uint64_t(0));
    }
};

GRIPSCOPE_TEST(ProfilePortTest)
#include "profile_port_test.moc"
