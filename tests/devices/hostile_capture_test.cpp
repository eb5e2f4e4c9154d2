// SPDX-License-Identifier: GPL-3.0-or-later
// Captures that somebody made to do harm: each is answered with an error or with what is whole of it.
#include "devices/protocol/codec.h"
#include "devices/replay/capture_folder.h"
#include "devices/replay/capture_reader.h"
#include "devices/replay/captured_session.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace gripscope;
using namespace gripscope::protocol;
using namespace Qt::StringLiterals;

namespace {

QByteArray note(std::uint64_t time_us, const QByteArray& text)
{
    return encodeRecord(time_us, CaptureKind::Note,
                        {reinterpret_cast<const std::uint8_t*>(text.constData()), std::size_t(text.size())});
}

/// A session: what the gripper says of itself, `between`, and a stretch of samples of which some move.
QByteArray session(double sampleTime_s, const QByteArray& between)
{
    MeasurementFeature measurement;
    measurement.sampleTime_s = sampleTime_s;
    measurement.forcePerCount = 1e-3;
    measurement.positionPerCount = 1e-9;
    measurement.commandable = true;
    QByteArray bytes = captureHeader();
    const auto add = [&](CaptureKind kind, std::uint64_t time_us, const Report& report) {
        bytes += encodeRecord(time_us, kind, report);
    };
    add(CaptureKind::Feature, 0, encode(IdentityFeature{"GS-1", "1.0", "Gripper"}));
    add(CaptureKind::Feature, 0, encode(measurement));
    add(CaptureKind::Feature, 0, encode(LimitsFeature{100000, 50000000, 20000}));
    bytes += between;
    for (std::uint32_t i = 0; i < 200; ++i) {
        StreamReport stream;
        stream.reportSequence = i;
        stream.firstSample = i;
        stream.timestamp_us = 500 * i;
        stream.count = 1;
        stream.status = i > 50 && i < 150 ? StatusArmed | StatusMoving : 0;
        add(CaptureKind::Input, 1000 + 500 * i, encode(stream));
    }
    return bytes;
}

} // namespace

class HostileCaptureTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;
    QString written(const QString& name, const QByteArray& bytes)
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() ? file.fileName()
                                                                                    : QString();
    }

private slots:
    void theSessionOfThisTestIsOne()
    {
        const auto good = readCapturedSession(written(
            u"good.gscap"_s, session(0.0005, note(500, "squeeze begins\nmode: movement\nsamples: 100\n"))));
        QVERIFY2(good, qPrintable(test::whyNot(good)));
        QCOMPARE(good->counters.samples, std::uint64_t(200));
        QCOMPARE(good->squeezes.size(), std::size_t(1));
    }
    void aSampleTimeThatNoGripperHasIsRefused_data()
    {
        QTest::addColumn<double>("sampleTime");
        for (const double sampleTime : {1e-22, 1e-15, 5e-324, 10.0, 1e300})
            QTest::addRow("%g s", sampleTime) << sampleTime;
    }
    void aSampleTimeThatNoGripperHasIsRefused()
    {
        QFETCH(double, sampleTime);
        const QByteArray squeezes = note(500, "squeeze begins\nmode: movement\nsamples: 100\n");
        QVERIFY(!readCapturedSession(written(u"time.gscap"_s, session(sampleTime, squeezes))));
    }
    void aCountThatNoSqueezeHasIsPassedOver()
    {
        const QByteArray begins = note(500, "squeeze begins\nmode: movement\nsamples: 9999999999999999999\n");
        const auto read = readCapturedSession(written(u"count.gscap"_s, session(0.0005, begins)));
        QVERIFY2(read, qPrintable(test::whyNot(read)));
        QVERIFY(read->squeezes.empty());
    }
    void moreSqueezesThanASessionHasAreAnError()
    {
        QByteArray many;
        for (int i = 0; i < 11'000; ++i)
            many += note(500, "squeeze begins\nmode: movement\nsamples: 1\n");
        const auto read = readCapturedSession(written(u"many.gscap"_s, session(0.0005, many)));
        QCOMPARE(read.error().code, ErrorCode::BadInput);
        QVERIFY2(read.error().describe().contains(u"squeezes"_s), qPrintable(read.error().describe()));
    }
    void partsWithoutRecordsDoNotNest()
    {
        QTemporaryDir parts;
        constexpr int count = 60'000; // each a few hundred bytes of stack, were they nested
        for (int i = 1; i <= count; ++i) {
            QFile file(parts.filePath(u"s.part%1.gscap"_s.arg(i, 5, 10, QLatin1Char('0'))));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(captureHeader()) == 8);
        }
        Expected<CaptureReader> reader = CaptureReader::open(parts.filePath(u"s.part00001.gscap"_s));
        QVERIFY(reader);
        const auto record = reader->next();
        QVERIFY(record && !*record);
    }
    void aTimeBeyondAnySessionIsAnError()
    {
        const QByteArray bytes = captureHeader() + note(~std::uint64_t(0), "x");
        QCOMPARE(parseCapture(bytes, u"x"_s).error().code, ErrorCode::BadInput);
    }
#ifdef Q_OS_UNIX
    void aPipeIsNoCapture()
    {
        const QString pipe = m_folder.filePath(u"pipe.gscap"_s);
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        QCOMPARE(readCapture(pipe).error().code, ErrorCode::FileUnreadable);
        QCOMPARE(readCapturedSession(pipe).error().code, ErrorCode::FileUnreadable);
    }
#endif
};

GRIPSCOPE_TEST(HostileCaptureTest)
#include "hostile_capture_test.moc"
