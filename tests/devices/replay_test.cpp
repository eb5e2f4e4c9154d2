// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "devices/replay/capture.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using Clock = std::chrono::steady_clock;

namespace {

/// 0.3 s at 1 kHz with a gap of ten samples; what the numbers are does not matter.
Recording recording(bool fromDevice)
{
    Recording out;
    out.sampleTime_s = 0.001;
    out.forceUnit = u"N"_qs;
    out.positionUnit = u"mm"_qs;
    out.hold = ForceHold::Zero;
    out.forceLag_s = 0.0001;
    out.provenance[u"serial"_qs] = u"GS-9"_qs;
    for (std::uint64_t i = 0; i < 300; ++i) {
        if (i >= 100 && i < 110)
            continue;
        out.time_s.push_back(5 + 0.001 * static_cast<double>(i));
        out.force.push_back(0.1 * static_cast<double>(i % 7));
        out.position.push_back(1.0 / static_cast<double>(i + 1));
        if (fromDevice) {
            out.sequence.push_back(1000 + i);
            out.status.push_back(i > 150 ? StatusMoving : 0);
        }
    }
    return out;
}

Expected<std::vector<CaptureRecord>> parse(const QByteArray& bytes)
{
    return parseCapture(bytes, u"x.gscap"_qs);
}

} // namespace

class ReplayTest : public QObject {
    Q_OBJECT
private slots:
    void aRecordingComesBackAsItIs_data()
    {
        QTest::addColumn<bool>("fromDevice");
        QTest::newRow("with numbers and status") << true;
        QTest::newRow("with times only") << false;
    }
    void aRecordingComesBackAsItIs()
    {
        QFETCH(bool, fromDevice);
        QTemporaryDir folder;
        const QString file = folder.filePath(u"squeeze.csv"_qs);
        const Recording original = recording(fromDevice);
        QVERIFY(writeRecordingCsv(original, file).has_value());

        const auto started = Clock::now();
        OpenPort replay(u"replay:"_qs + file);
        QVERIFY(replay.ready());
        const GripperIdentity identity = replay.port->identity();
        QVERIFY(!identity.commandable);
        QCOMPARE(identity.positionUnit, u"mm"_qs);
        QCOMPARE(identity.sampleTime_s, 0.001);
        QCOMPARE(identity.forceLag_s, 0.0001);
        QCOMPARE(identity.serial, u"GS-9"_qs);
        QVERIFY(identity.hold == ForceHold::Zero);
        QVERIFY(!replay.gate.arm(u"tester"_qs));

        QVERIFY(replay.pollUntil([&] { return replay.port->state() == LinkState::Closed; }));
        QVERIFY(Clock::now() - started >= std::chrono::milliseconds(299)); // the pace it was recorded at
        QVERIFY(replay.port->lastError()->describe().contains(u"replayed to its end"_qs));
        QCOMPARE(replay.samples.size(), original.size());
        for (std::size_t i = 0; i < original.size(); ++i) {
            QCOMPARE(replay.samples[i].time_s, original.time_s[i]);
            QCOMPARE(replay.samples[i].force, original.force[i]);
            QCOMPARE(replay.samples[i].position, original.position[i]);
            QCOMPARE(replay.samples[i].sequence, (fromDevice ? 1000 : 0) + (i < 100 ? i : i + 10));
            QCOMPARE(replay.samples[i].status, fromDevice ? original.status[i] : std::uint16_t(0));
        }
        QCOMPARE(replay.port->counters().lostSamples, std::uint64_t(10));
        QCOMPARE(replay.port->counters().samples, std::uint64_t(original.size()));
    }

    void aFileThatIsNoneIsTold()
    {
        OpenPort missing(u"replay:/nowhere/x.csv"_qs);
        QVERIFY(waitForState(*missing.port, LinkState::Lost));
        QVERIFY(missing.port->lastError()->code == ErrorCode::FileUnreadable);
        OpenPort capture(u"replay:/nowhere/x.gscap"_qs);
        QVERIFY(waitForState(*capture.port, LinkState::Lost));
        QVERIFY(capture.port->lastError()->code == ErrorCode::FileUnreadable);
    }

    void aCaptureComesBackWithItsFaults()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(u"squeeze.gscap"_qs);
        OpenPort original(u"virtual:?speed=0&fault=loss:0.05,crc:0.05,duplicate:0.05&capture="_qs + file);
        QCOMPARE(original.squeeze(usualForce(500)), SqueezeState::Finished);
        original.port->drain(original.samples);
        original.port->close();
        const LinkCounters expected = original.port->counters();

        OpenPort replay(u"replay:"_qs + file);
        QVERIFY(replay.pollUntil([&] { return replay.port->state() == LinkState::Closed; }));
        QVERIFY(!replay.port->identity().commandable);
        replay.port->drain(replay.samples);
        QVERIFY(replay.port->lastError()->describe().contains(u"replayed to its end"_qs));
        const LinkCounters counters = replay.port->counters();
        QCOMPARE(counters.reports, expected.reports);
        QCOMPARE(counters.badReports, expected.badReports);
        QCOMPARE(counters.duplicateReports, expected.duplicateReports);
        QCOMPARE(counters.lostSamples, expected.lostSamples);
        QCOMPARE(replay.samples.size(), original.samples.size());
        for (std::size_t i = 0; i < replay.samples.size(); ++i) {
            QCOMPARE(replay.samples[i].sequence, original.samples[i].sequence);
            QCOMPARE(replay.samples[i].time_s, original.samples[i].time_s);
            QCOMPARE(replay.samples[i].force, original.samples[i].force);
            QCOMPARE(replay.samples[i].position, original.samples[i].position);
            QCOMPARE(replay.samples[i].status, original.samples[i].status);
        }
    }

    void aCaptureThatCannotBeWrittenIsTold()
    {
        OpenPort gripper(u"virtual:?capture=/nowhere/x.gscap"_qs);
        QVERIFY(waitForState(*gripper.port, LinkState::Lost));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::FileUnwritable);
    }

    void captureRecordsAreReadAsTheyWereWritten()
    {
        const std::vector<CaptureRecord> records{{0, CaptureKind::Feature, {1, 2, 3}},
                                                 {7, CaptureKind::Input, {}},
                                                 {7, CaptureKind::Output, std::vector<std::uint8_t>(128, 9)}};
        QByteArray bytes = captureHeader();
        for (const CaptureRecord& record : records)
            bytes += encodeRecord(record.time_us, record.kind, record.bytes);
        QVERIFY(parse(bytes) == records);
        // Cut anywhere, it gives the whole records before the cut.
        for (qsizetype length = captureHeader().size(); length < bytes.size(); ++length) {
            const auto part = parse(bytes.left(length));
            QVERIFY(part.has_value());
            QVERIFY(part->size() < records.size());
            QVERIFY(std::equal(part->begin(), part->end(), records.begin()));
        }
    }

    void badCapturesAreRefusedWithThePlace_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("place");
        const QByteArray header = captureHeader();
        const std::vector<std::uint8_t> report{1};
        QTest::newRow("empty") << QByteArray() << u"x.gscap:0"_qs;
        QTest::newRow("something else") << QByteArray("time_s,force,position\n") << u"x.gscap:0"_qs;
        QTest::newRow("unknown kind")
            << header + encodeRecord(0, static_cast<CaptureKind>(4), report) << u"x.gscap:16"_qs;
        QTest::newRow("long report") << header + encodeRecord(0, CaptureKind::Input,
                                                              std::vector<std::uint8_t>(129))
                                     << u"x.gscap:18"_qs;
        QTest::newRow("time runs back") << header + encodeRecord(5, CaptureKind::Input, report) +
                                               encodeRecord(4, CaptureKind::Input, report)
                                        << u"x.gscap:21"_qs;
    }
    void badCapturesAreRefusedWithThePlace()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, place);
        const auto capture = parse(bytes);
        QVERIFY(!capture);
        QVERIFY(capture.error().code == ErrorCode::BadInput);
        QCOMPARE(capture.error().argument(0), place);
    }
};

GRIPSCOPE_TEST(ReplayTest)
#include "replay_test.moc"
