// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/packed_recording.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <QtEndian>

#include <bit>
#include <limits>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class RecordingCodecTest : public QObject {
    Q_OBJECT
private slots:
    void everyBitComesBack()
    {
        const Recording recording = awkwardRecording();
        const Recording back = valueOf(decodeRecording(valueOf(encodeRecording(recording))));
        QVERIFY(back == recording);
        for (std::size_t i = 0; i < recording.size(); ++i) // == takes -0 for 0
            QCOMPARE(std::bit_cast<quint64>(back.position[i]), std::bit_cast<quint64>(recording.position[i]));
    }
    void numbersThatAreNoneAreKeptOut_data()
    {
        QTest::addColumn<double>("number");
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("none") << std::bit_cast<double>(0x7ff8000000000123u);
        QTest::newRow("beyond any reading") << 1e200;
    }
    void numbersThatAreNoneAreKeptOut()
    {
        QFETCH(double, number);
        Recording recording = awkwardRecording(2);
        recording.provenance.clear();
        QByteArray bytes = valueOf(encodeRecording(recording));
        recording.force[1] = number;
        QCOMPARE(encodeRecording(recording).error().code, ErrorCode::Usage);
        // Somebody else may have written them.
        const qsizetype force1 = bytes.size() - 2 * (8 + 8 + 8 + 2) + 8;
        qToLittleEndian(number, bytes.data() + force1);
        QCOMPARE(decodeRecording(bytes).error().code, ErrorCode::StorageCorrupt);
    }
    void aSampleTimeOutOfRangeIsKeptOut()
    {
        QByteArray bytes = valueOf(encodeRecording(awkwardRecording(2)));
        qToLittleEndian(1e-22, bytes.data() + 6);
        QVERIFY(decodeRecording(bytes).error().describe().contains(u"sample time"_s));
    }
    void whatIsAbsentStaysAbsent_data()
    {
        QTest::addColumn<int>("absent");
        for (int absent = 0; absent < 8; ++absent)
            QTest::addRow("%d", absent) << absent;
    }
    void whatIsAbsentStaysAbsent()
    {
        QFETCH(int, absent);
        Recording recording = awkwardRecording(3);
        if (absent & 1)
            recording.sequence.clear();
        if (absent & 2)
            recording.status.clear();
        if (absent & 4)
            recording.hold.reset();
        else
            recording.hold = ForceHold::First;
        QVERIFY(valueOf(decodeRecording(valueOf(encodeRecording(recording)))) == recording);
    }
    void anEmptyRecordingComesBack()
    {
        QVERIFY(valueOf(decodeRecording(valueOf(encodeRecording(Recording{})))) == Recording{});
    }
    void theLayoutIsTheOneThatIsDocumented()
    {
        Recording recording;
        recording.sampleTime_s = 1;
        recording.hold = ForceHold::Zero;
        recording.forceUnit = u"N"_s;
        recording.positionUnit = u"m"_s;
        recording.time_s = {0};
        recording.force = {2};
        recording.position = {-1};
        recording.status = {0x0102};
        recording.provenance = {{u"k"_s, u"v"_s}};
        const QByteArray wanted =
            QByteArray::fromHex("47535242 0100 000000000000f03f 0000000000000000 01"
                                "01000000 4e 01000000 6d"
                                "01000000 01000000 6b 01000000 76"
                                "0100000000000000 02"
                                "0000000000000000 0000000000000040 000000000000f0bf 0201");
        QCOMPARE(valueOf(encodeRecording(recording)).toHex(), wanted.toHex());
    }
    void theMeasuringChainComesBack_data()
    {
        QTest::addColumn<bool>("baseline");
        QTest::addColumn<double>("force_noise");
        QTest::addColumn<bool>("friction");
        QTest::addColumn<int>("version");
        QTest::newRow("without a baseline") << false << 0.0 << false << 2;
        QTest::newRow("with one") << true << 0.0 << false << 2;
        QTest::newRow("with the force's noise") << true << 0.02 << false << 3;
        QTest::newRow("with friction of its own") << false << 0.0 << true << 4;
        QTest::newRow("with all") << true << 0.02 << true << 4;
    }
    void theMeasuringChainComesBack()
    {
        QFETCH(bool, baseline);
        QFETCH(double, force_noise);
        QFETCH(bool, friction);
        Recording recording = awkwardRecording(3);
        recording.chain = {1.0 / 3e5, force_noise, 0.001, 0.002, 1e-5, 1e-7, {}, {}};
        if (friction)
            recording.chain.friction = GripperFriction{0.3, 1.0 / 300};
        if (baseline)
            recording.chain.baseline = GripperBaseline{{0.0025, 1.0 / 7, 12}, {1e-5, 0.01, 2}};
        const QByteArray bytes = valueOf(encodeRecording(recording));
        QTEST(int(bytes[4]), "version"); // the oldest that holds it
        QVERIFY(valueOf(decodeRecording(bytes)) == recording);
        for (qsizetype size = 0; size < bytes.size(); ++size)
            QCOMPARE(decodeRecording(bytes.left(size)).error().code, ErrorCode::StorageCorrupt);
        QCOMPARE(decodeRecording(bytes + '\0').error().code, ErrorCode::StorageCorrupt);
    }
    void withoutAChainTheOldLayoutIsKept()
    {
        QCOMPARE(int(valueOf(encodeRecording(awkwardRecording(1)))[4]), 1);
    }
    void channelsOfDifferentLengthAreRefused()
    {
        Recording recording = awkwardRecording(3);
        recording.status.pop_back();
        QCOMPARE(encodeRecording(recording).error().code, ErrorCode::Usage);
    }
    void everyTruncationAndExtensionIsNoticed()
    {
        const QByteArray bytes = valueOf(encodeRecording(awkwardRecording(3)));
        for (qsizetype size = 0; size < bytes.size(); ++size)
            QCOMPARE(decodeRecording(bytes.left(size)).error().code, ErrorCode::StorageCorrupt);
        QCOMPARE(decodeRecording(bytes + '\0').error().code, ErrorCode::StorageCorrupt);
    }
    void aDamagedCountTakesNoMemory()
    {
        QByteArray bytes = valueOf(encodeRecording(Recording{}));
        bytes.replace(bytes.size() - 9, 8, QByteArray(8, '\xff')); // samples
        QCOMPARE(decodeRecording(bytes).error().code, ErrorCode::StorageCorrupt);
    }
    void aNewerLayoutIsNamed()
    {
        QByteArray bytes = valueOf(encodeRecording(Recording{}));
        bytes[4] = 9;
        QVERIFY(decodeRecording(bytes).error().describe().contains(u"version 9"_s));
    }
};

GRIPSCOPE_TEST(RecordingCodecTest)
#include "recording_codec_test.moc"
