// SPDX-License-Identifier: GPL-3.0-or-later
// Every fault of the virtual gripper, over time: what the program sees is what the script did.
#include "devices/protocol/codec.h"
#include "tests/devices/watched_transport.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <future>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// As fast as it can: device time passes in squeezes alone, so that times of a script count from the first.
std::shared_ptr<WatchedTransport> instant(const QByteArray& script)
{
    return Watched::transport(0, script);
}

bool within(double time_s, double from_s, double to_s)
{
    return time_s >= from_s && time_s < to_s;
}

/// Stream reports of a gripper that nobody commands, for `seconds` of its time.
std::vector<protocol::StreamReport> listen(Transport& transport, std::size_t reports)
{
    std::vector<protocol::StreamReport> stream;
    Transport::Buffer buffer{};
    waitFor([&] {
        const Transport::ReadResult result = transport.read(buffer, std::chrono::milliseconds(20));
        if (result.outcome != Transport::Outcome::Report)
            return result.outcome == Transport::Outcome::Lost;
        const auto message = protocol::decodeInput(protocol::ReportView(buffer).first(result.size));
        if (message && std::holds_alternative<protocol::StreamReport>(*message))
            stream.push_back(std::get<protocol::StreamReport>(*message));
        return stream.size() >= reports;
    });
    return stream;
}

class ScriptFile {
public:
    explicit ScriptFile(const QByteArray& text)
    {
        QFile file(name());
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), qint64(text.size()));
    }
    QString name() const { return m_folder.filePath(u"faults.txt"_qs); }

private:
    QTemporaryDir m_folder;
};

} // namespace

class VirtualFaultsTest : public QObject {
    Q_OBJECT
private slots:
    void whatTheWireDidIsWhatIsCounted_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::newRow("loss") << QByteArray("0.2 loss 0.1\n0.8 loss 0");
        QTest::newRow("duplicates") << QByteArray("0.2 duplicate 0.1\n0.8 duplicate 0");
        QTest::newRow("bad CRC") << QByteArray("0.2 crc 0.1\n0.8 crc 0");
        QTest::newRow("a stall") << QByteArray("0.2 stall\n0.4 resume");
        QTest::newRow("all") << QByteArray("0.2 loss 0.1\n0.3 crc 0.1\n0.4 duplicate 0.2\n0.5 stall\n"
                                           "0.6 resume\n0.8 loss 0\n0.8 crc 0\n0.8 duplicate 0");
    }
    void whatTheWireDidIsWhatIsCounted()
    {
        QFETCH(QByteArray, script);
        Watched gripper(instant(script));
        QCOMPARE(gripper.squeeze(usualForce(2000)), SqueezeState::Finished);
        gripper.port->drain(gripper.samples);
        const LinkCounters seen = gripper.port->counters();
        const FaultCounts done = gripper.wire->faultCounts();
        QCOMPARE(seen.lostSamples, done.lostSamples);
        QCOMPARE(seen.badReports, done.damagedReports);
        QCOMPARE(seen.duplicateReports, done.duplicateReports);
        QCOMPARE(seen.samples + seen.lostSamples, done.samples);
        QCOMPARE(done.lostSamples > 0, !script.startsWith("0.2 duplicate"));
        QCOMPARE(done.damagedReports > 0, script.contains("crc"));
        QCOMPARE(done.duplicateReports > 0, script.contains("duplicate"));
        for (std::size_t i = 1; i < gripper.samples.size(); ++i)
            if (gripper.samples[i].sequence != gripper.samples[i - 1].sequence + 1)
                QVERIFY(within(gripper.samples[i].time_s, 0.2, 0.81));
    }

    void saturationComesAndGoes()
    {
        Watched gripper(instant("0.2 saturate 15\n0.4 saturate off"));
        QCOMPARE(gripper.squeeze(usualForce(1000)), SqueezeState::Finished);
        std::size_t saturated = 0;
        for (const Sample& sample : gripper.samples) {
            const bool marked = sample.status & StatusForceSaturated;
            saturated += marked ? 1 : 0;
            QVERIFY(!marked || (sample.force == 15.0 && within(sample.time_s, 0.199, 0.401)));
            QVERIFY(sample.force <= 15.0 || !within(sample.time_s, 0.201, 0.399));
        }
        QVERIFY(saturated > 100);
    }

    void aSensorSticksAndComesLoose()
    {
        Watched gripper(instant("0.2 stuck\n0.4 stuck off"));
        QCOMPARE(gripper.squeeze(usualForce(1000)), SqueezeState::Finished);
        std::vector<double> stuck, loose;
        for (const Sample& sample : gripper.samples)
            (within(sample.time_s, 0.201, 0.399) ? stuck : loose).push_back(sample.position);
        QVERIFY(stuck.size() > 300);
        QCOMPARE(*std::max_element(stuck.begin(), stuck.end()),
                 *std::min_element(stuck.begin(), stuck.end()));
        QVERIFY(*std::max_element(loose.begin(), loose.end()) > stuck.front());
        QVERIFY(*std::min_element(loose.begin(), loose.end()) < stuck.front());
    }

    void theClockSteps()
    {
        const auto transport = Watched::transport(100, "0.1 clock 0.5\n0.2 clock -0.7");
        QVERIFY(transport->open().has_value());
        for (const protocol::StreamReport& report : listen(*transport, 400)) {
            const double samples_s = 0.0005 * report.firstSample;
            const auto ahead_us = static_cast<std::int32_t>(report.timestamp_us - 500 * report.firstSample);
            const int expected_us = samples_s < 0.1 ? 0 : samples_s < 0.2 ? 500000 : -200000;
            QCOMPARE(ahead_us, expected_us);
        }
    }

    void aStallEndsWithAGapAndTheLinkLives()
    {
        Watched gripper(Watched::transport(10, "1 stall\n1.5 resume"));
        QVERIFY(gripper.pollUntil([&] { return gripper.port->counters().lostSamples > 0; }));
        QCOMPARE(gripper.port->counters().lostSamples, std::uint64_t(1000));
        QVERIFY(gripper.port->state() == LinkState::Ready);
    }

    void anUnpluggedGripperComesBackAndItsFaultsGoOn()
    {
        OpenPort gripper(u"virtual:?speed=10&fault=unplug:1,replug:20"_qs);
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; }));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceLost);
        gripper.port->open();
        QVERIFY(waitForState(*gripper.port, LinkState::Lost));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceNotFound); // not back yet
        QVERIFY(gripper.pollUntil([&] {
            if (gripper.port->state() == LinkState::Lost)
                gripper.port->open();
            return gripper.port->state() == LinkState::Ready;
        }));
        // The unplug is behind it: it stays.
        gripper.samples.clear();
        QVERIFY(gripper.pollUntil([&] { return gripper.samples.size() > 2 * 2000; }));
        QVERIFY(gripper.port->state() == LinkState::Ready);
    }

    void aNewConnectionBeginsFromTheBeginning()
    {
        const QString address = u"virtual:?speed=10&seed=77&fault=unplug:1,replug:0.1"_qs;
        for (int connection = 0; connection < 2; ++connection) {
            OpenPort gripper(address);
            QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; }));
            gripper.port->close();
            // What came back is taken up, and left in good order.
            QVERIFY(waitFor([&] {
                gripper.port->open();
                return waitFor([&] { return gripper.port->state() != LinkState::Opening; }) &&
                       gripper.port->state() == LinkState::Ready;
            }));
        }
    }

    void aDeafGripperAnswersNothing()
    {
        Watched gripper(Watched::transport(1, "0 deaf"));
        QVERIFY(gripper.ready());
        QVERIFY(gripper.gate.arm(u"tester"_qs).has_value());
        QVERIFY(gripper.pollUntil([&] { return gripper.port->lastError().has_value(); }));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceTimeout);
        QVERIFY(gripper.port->state() == LinkState::Ready);
    }

    void heartbeatsThatDoNotArriveStopIt()
    {
        Watched gripper(Watched::transport(1, "0 deaf heartbeat"));
        QVERIFY(gripper.ready() && gripper.arm());
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Ready; }));
        QVERIFY(gripper.pollUntil([&] { return statusSeen(gripper.samples) & StatusWatchdog; }));
        QVERIFY(gripper.wire->heartbeats.load() > 0);
    }

    void aFeatureRequestHangs()
    {
        OpenPort gripper(std::make_unique<DevicePort>(
            u"virtual:"_qs, [] { return Watched::transport(1, "0 hang-feature 0.5"); }));
        QVERIFY(waitForState(*gripper.port, LinkState::Lost));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceTimeout);
    }

    void aWriteHangsWhileReportsAreRead()
    {
        const auto transport = Watched::transport(1, "0 hang-write 1");
        QVERIFY(transport->open().has_value());
        std::atomic<bool> ended{false};
        const auto writing = std::async(std::launch::async, [&] {
            const bool taken =
                transport->write(protocol::encode(protocol::Command{1, protocol::StopCommand{}}));
            ended = true;
            return taken;
        });
        QVERIFY(listen(*transport, 100).size() == 100); // a tenth of a second
        QVERIFY(waitFor([&] { return ended.load(); }));
    }

    void aBrokenGripperDoesNotArm()
    {
        Watched gripper(Watched::transport(1, "0 broken"));
        QVERIFY(gripper.ready());
        QVERIFY(gripper.gate.arm(u"tester"_qs).has_value());
        QVERIFY(gripper.pollUntil([&] { return gripper.port->lastError().has_value(); }));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceRefused);
        QVERIFY(gripper.pollUntil([&] { return statusSeen(gripper.samples) & StatusFault; }));
    }

    void aScriptComesFromItsFile()
    {
        const ScriptFile script("0.3 unplug\n");
        OpenPort gripper(u"virtual:?speed=10&script="_qs + script.name());
        QVERIFY(gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; }));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceLost);
        QVERIFY(gripper.samples.empty() || gripper.samples.back().sequence < 600);
    }

    void aScriptThatMakesNoSenseIsToldWhenItIsOpened()
    {
        const ScriptFile script("1 stall\n2 resumes\n");
        OpenPort gripper(u"virtual:?script="_qs + script.name());
        QVERIFY(waitForState(*gripper.port, LinkState::Lost));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::BadInput);
        QVERIFY(gripper.port->lastError()->describe().contains(script.name() + u":2:3"_qs));
    }
};

GRIPSCOPE_TEST(VirtualFaultsTest)
#include "virtual_faults_test.moc"
