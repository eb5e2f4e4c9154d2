// SPDX-License-Identifier: GPL-3.0-or-later
// From the bytes of another maker's gripper to samples: numbers, counters that come round, losses.
#include "devices/profile/field_values.h"
#include "devices/profile/profile_codec.h"
#include "devices/profile/profile_library.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

using Bytes = std::vector<std::uint8_t>;

GripperProfile example(const QString& name)
{
    return namedProfile(name).value();
}

bool accepted(const ReportDecoder::Taken& taken)
{
    return std::holds_alternative<ReportDecoder::Stream>(taken);
}

/// Reports with a counter and a clock as the profile has them, to decide which of them arrive.
class Stream {
public:
    explicit Stream(const GripperProfile& profile) : m_profile(profile), m_encoder(profile) {}

    Bytes next(double clockStep_s = 0)
    {
        m_clock_s += clockStep_s;
        const std::vector<ProfileEncoder::Reading> readings(m_profile.samples, {12, 0.01, 0});
        const double time_s = m_clock_s + static_cast<double>(m_reports++) * m_profile.reportTime_s();
        return m_encoder.encode(readings, time_s);
    }
    void skip(int reports)
    {
        for (int i = 0; i < reports; ++i)
            static_cast<void>(next());
    }

private:
    GripperProfile m_profile;
    ProfileEncoder m_encoder;
    std::uint64_t m_reports = 0;
    double m_clock_s = 0;
};

GripperProfile withSequence(FieldType type)
{
    GripperProfile profile = example(u"example_big_endian"_s);
    profile.reportLength = 16;
    profile.sequence = ProfileSequence{{8, type, true, 0, 0, false}, false};
    return profile;
}

GripperProfile withClock(GripperProfile profile, FieldType type)
{
    profile.reportLength = 16;
    profile.time = ProfileTime{{12, type, false, 0, 0, false}, 1, u"us"_s};
    return profile;
}

} // namespace

class ProfileDecoderTest : public QObject {
    Q_OBJECT
private slots:
    void numbersAreReadAsTheProfileSays()
    {
        ProfileDecoder decoder(example(u"example_big_endian"_s));
        std::vector<Sample> samples;
        // -1000 and 0x0BB8 = 3000, highest byte first; flags: moving and force saturated.
        QVERIFY(accepted(decoder.take(Bytes{4, 17, 0x11, 0, 0xFC, 0x18, 0x0B, 0xB8}, samples)));
        QCOMPARE(samples.size(), std::size_t(1));
        QCOMPARE(samples[0].force, -10.0);
        QCOMPARE(samples[0].position, 35.0);
        QCOMPARE(samples[0].sequence, std::uint64_t(17));
        QCOMPARE(samples[0].time_s, 17 * 0.002);
        QCOMPARE(samples[0].status, std::uint16_t(StatusMoving | StatusForceSaturated));
    }
    void aReportMayCarrySeveralSamples()
    {
        ProfileDecoder decoder(example(u"example_float_stream"_s));
        Bytes report(40, 0);
        report[1] = 1;                                                        // 256 us
        report[16] = 0, report[17] = 0, report[18] = 0x20, report[19] = 0x41; // 10.0f
        std::vector<Sample> samples;
        QVERIFY(accepted(decoder.take(report, samples)));
        QCOMPARE(samples.size(), std::size_t(4));
        QCOMPARE(samples[0].time_s, 256e-6);
        QCOMPARE(samples[1].force, 10.0);
        QCOMPARE(samples[3].time_s, 256e-6 + 3 * 0.0005);
        report[19] = 0xFF, report[18] = 0xFF; // no number any more
        report[1] = 9;
        QVERIFY(std::holds_alternative<protocol::DecodeError>(decoder.take(report, samples)));
    }
    void aFieldMayBePartOfANumber()
    {
        ProfileDecoder decoder(example(u"example_bare"_s));
        std::vector<Sample> samples;
        QVERIFY(accepted(decoder.take(Bytes{0x00, 0xA8, 0x10, 0x27, 0, 0, 0, 0}, samples)));
        QVERIFY(std::abs(samples[0].force) < 1e-12); // 0x800, though the battery's bits are set
        QCOMPARE(samples[0].position, 1000.0);
    }
    void signedPartsOfANumberKeepTheirSign()
    {
        const ProfileField field{0, FieldType::I16, false, 4, 12, false};
        QCOMPARE(field.number(Bytes{0xF0, 0xFF}), -1.0);
        QCOMPARE(field.number(Bytes{0x0F, 0x80}), -2048.0);
        Bytes report{0x05, 0};
        QVERIFY(field.put(-2, report));
        QCOMPARE(report, (Bytes{0xE5, 0xFF}));
        QVERIFY(!field.put(3000, report));
        QCOMPARE(field.number(report), 2047.0);
    }
    void everyTypeReadsWhatItWrote_data()
    {
        QTest::addColumn<int>("type");
        for (int i = 0; i <= static_cast<int>(FieldType::F32); ++i)
            QTest::newRow(qPrintable(toString(static_cast<FieldType>(i)))) << i;
    }
    void everyTypeReadsWhatItWrote()
    {
        QFETCH(int, type);
        for (const bool bigEndian : {false, true}) {
            const ProfileField field{2, static_cast<FieldType>(type), bigEndian, 0, 0, false};
            for (const double value : {field.least(), field.most(), 0.0, 100.0}) {
                Bytes report(8, 0x55);
                QVERIFY(field.put(value, report));
                QCOMPARE(field.number(report), value);
                QCOMPARE(report[1], std::uint8_t(0x55));
                QCOMPARE(report[2 + field.size()], std::uint8_t(0x55));
            }
        }
    }
    void reportsOfAnotherLengthAreBadAndThoseOfAnotherIdAreNone()
    {
        ProfileDecoder decoder(example(u"example_big_endian"_s));
        std::vector<Sample> samples;
        QVERIFY(std::holds_alternative<protocol::DecodeError>(decoder.take(Bytes{4, 1, 0}, samples)));
        QVERIFY(std::holds_alternative<ReportDecoder::Other>(decoder.take(Bytes(8, 9), samples)));
        QVERIFY(std::holds_alternative<ReportDecoder::Other>(decoder.take(Bytes{}, samples)));
        QVERIFY(samples.empty());
    }
    void lossesAreCountedThroughEveryRoundOfTheCounter_data()
    {
        QTest::addColumn<int>("type");
        QTest::newRow("u8") << static_cast<int>(FieldType::U8);
        QTest::newRow("u16") << static_cast<int>(FieldType::U16);
        QTest::newRow("u32") << static_cast<int>(FieldType::U32);
    }
    void lossesAreCountedThroughEveryRoundOfTheCounter()
    {
        QFETCH(int, type);
        const GripperProfile profile = withSequence(static_cast<FieldType>(type));
        ProfileDecoder decoder(profile);
        Stream stream(profile);
        std::vector<Sample> samples;
        for (int i = 0; i < 70000; ++i) {
            const Bytes report = stream.next();
            if (i % 100 < 7)
                continue; // lost: 7 in a row
            QVERIFY(accepted(decoder.take(report, samples)));
            if (i % 1000 == 550)
                QVERIFY(std::holds_alternative<ReportDecoder::Duplicate>(decoder.take(report, samples)));
        }
        QCOMPARE(decoder.counts().lostSamples, std::uint64_t(7 * 699)); // not those before the first
        QCOMPARE(decoder.counts().duplicateReports, std::uint64_t(70));
        QCOMPARE(samples.back().sequence - samples.front().sequence + 1,
                 samples.size() + decoder.counts().lostSamples);
        QCOMPARE(samples.back().time_s, static_cast<double>(samples.back().sequence) * 0.002);
    }
    void aClockTellsHowOftenAShortCounterCameRound()
    {
        const GripperProfile profile = withClock(withSequence(FieldType::U8), FieldType::U32);
        ProfileDecoder decoder(profile);
        Stream stream(profile);
        std::vector<Sample> samples;
        for (const int lost : {0, 3, 255, 256, 257, 1000, 100000}) {
            const std::uint64_t before = decoder.counts().lostSamples;
            QVERIFY(accepted(decoder.take(stream.next(), samples)));
            stream.skip(lost);
            QVERIFY(accepted(decoder.take(stream.next(), samples)));
            QCOMPARE(decoder.counts().lostSamples - before, std::uint64_t(lost));
        }
    }
    void aClockThatJumpsIsNoLoss()
    {
        const GripperProfile profile = withClock(withSequence(FieldType::U8), FieldType::U32);
        ProfileDecoder decoder(profile);
        Stream stream(profile);
        std::vector<Sample> samples;
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        QVERIFY(accepted(decoder.take(stream.next(7.7), samples)));
        QCOMPARE(decoder.counts().lostSamples, std::uint64_t(0));
        QVERIFY(samples[1].time_s > samples[0].time_s + 7);
        QVERIFY(accepted(decoder.take(stream.next(-3), samples)));
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        QCOMPARE(decoder.counts().clockSteps, std::uint64_t(2));
        QVERIFY(samples[1].clockStepped && samples[2].clockStepped && !samples[3].clockStepped);
        QCOMPARE(decoder.counts().lostSamples, std::uint64_t(0));
        for (std::size_t i = 1; i < samples.size(); ++i)
            QVERIFY(samples[i].time_s > samples[i - 1].time_s); // time never runs backwards
    }
    void aShortClockIsFollowedByTheCounter()
    {
        const GripperProfile profile = withClock(withSequence(FieldType::U32), FieldType::U16); // 65 ms
        ProfileDecoder decoder(profile);
        Stream stream(profile);
        std::vector<Sample> samples;
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        stream.skip(4999);
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        QCOMPARE(decoder.counts().lostSamples, std::uint64_t(4999));
        QVERIFY(std::abs(samples[1].time_s - samples[0].time_s - 10) < 1e-9);
    }
    void withoutACounterLossesAreSeenByTheClock()
    {
        const GripperProfile profile = example(u"example_float_stream"_s);
        ProfileDecoder decoder(profile);
        Stream stream(profile);
        std::vector<Sample> samples;
        static_cast<void>(stream.next(4294.9)); // the clock comes round in 67 ms
        for (int i = 0; i < 500; ++i) {
            const Bytes report = stream.next();
            if (i % 50 != 7)
                QVERIFY(accepted(decoder.take(report, samples)));
            if (i % 50 == 9)
                QVERIFY(std::holds_alternative<ReportDecoder::Duplicate>(decoder.take(report, samples)));
        }
        QCOMPARE(decoder.counts().lostSamples, std::uint64_t(10 * 4));
        QCOMPARE(decoder.counts().duplicateReports, std::uint64_t(10));
        for (std::size_t i = 1; i < samples.size(); ++i)
            QVERIFY(samples[i].time_s > samples[i - 1].time_s);
    }
    void withoutEitherLossesAreNotSeenAndTheIdentitySaysSo()
    {
        const GripperProfile profile = example(u"example_bare"_s);
        ProfileDecoder decoder(profile);
        Stream stream(profile);
        std::vector<Sample> samples;
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        stream.skip(10);
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        QCOMPARE(decoder.counts().lostSamples, std::uint64_t(0));
        QCOMPARE(samples[1].sequence, std::uint64_t(1));
        QCOMPARE(samples[1].time_s, 0.004);
    }
    void aDeviceThatBeginsAnewIsNoticed()
    {
        const GripperProfile profile = withSequence(FieldType::U32);
        ProfileDecoder decoder(profile);
        Stream stream(profile);
        std::vector<Sample> samples;
        stream.skip(1000);
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        Stream again(profile);
        QVERIFY(std::holds_alternative<ReportDecoder::Restarted>(decoder.take(again.next(), samples)));
    }
    void aCounterThatDoesNotCountSamplesIsABadReport()
    {
        GripperProfile profile = example(u"example_float_stream"_s);
        profile.sequence = ProfileSequence{{4, FieldType::U16, false, 0, 0, false}, false};
        Stream stream(profile);
        profile.sequence->countsSamples = true; // it counts reports, four samples each
        ProfileDecoder decoder(profile);
        std::vector<Sample> samples;
        QVERIFY(accepted(decoder.take(stream.next(), samples)));
        QVERIFY(std::holds_alternative<protocol::DecodeError>(decoder.take(stream.next(), samples)));
    }
    void theFieldsOfAReportAreToldOneByOne()
    {
        const GripperProfile profile = example(u"example_float_stream"_s);
        const std::vector<FieldValue> values = fieldValues(profile, Stream(profile).next());
        QCOMPARE(values.size(), std::size_t(9)); // 4 x force, 4 x position, time
        QCOMPARE(values[1].byte, std::size_t(16));
        QCOMPARE(values[1].value, 12.0);
        QCOMPARE(ownersOfByte(profile, 17), u"force 2"_s);
        QCOMPARE(ownersOfByte(profile, 5), QString());
        QCOMPARE(ownersOfByte(example(u"example_big_endian"_s), 0), u"report ID"_s);
        QVERIFY(fieldValues(profile, Bytes(3, 0)).empty());
    }
};

GRIPSCOPE_TEST(ProfileDecoderTest)
#include "profile_decoder_test.moc"
