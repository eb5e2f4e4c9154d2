// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/codec.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <random>

using namespace gripscope;
using namespace gripscope::protocol;

namespace {

class Random {
public:
    template <typename T>
    T number()
    {
        return static_cast<T>(m_generator());
    }
    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(m_generator() % limit); }
    double positive() { return 1e-6 * (1 + below(1000000)); }
    std::string text(std::size_t most)
    {
        std::string out(below(static_cast<std::uint32_t>(most + 1)), ' ');
        for (char& c : out)
            c = static_cast<char>('!' + below(90));
        return out;
    }

private:
    std::mt19937_64 m_generator{20240501};
};

StreamReport randomStream(Random& random)
{
    StreamReport report;
    report.status = random.number<std::uint16_t>();
    report.reportSequence = random.number<std::uint32_t>();
    report.firstSample = random.number<std::uint32_t>();
    report.timestamp_us = random.number<std::uint32_t>();
    report.excitation = static_cast<ExcitationState>(random.below(5));
    report.excitationNumber = random.number<std::uint16_t>();
    report.count = static_cast<std::uint8_t>(random.below(maxSamplesPerReport + 1));
    for (std::size_t i = 0; i < report.count; ++i)
        report.samples[i] = {random.number<std::int32_t>(), random.number<std::int32_t>()};
    return report;
}

Acknowledgement randomAnswer(Random& random)
{
    Acknowledgement answer;
    answer.status = random.number<std::uint16_t>();
    answer.commandNumber = random.number<std::uint16_t>();
    answer.command = static_cast<ReportId>(random.number<std::uint8_t>());
    answer.result = static_cast<CommandResult>(random.below(11));
    answer.detail = random.number<std::uint32_t>();
    answer.timestamp_us = random.number<std::uint32_t>();
    answer.excitation = static_cast<ExcitationState>(random.below(5));
    answer.excitationNumber = random.number<std::uint16_t>();
    return answer;
}

Command randomCommand(Random& random)
{
    Command command{random.number<std::uint16_t>(), {}};
    switch (random.below(8)) {
    case 0:
        command.body = ArmCommand{random.number<std::uint32_t>()};
        break;
    case 1:
        command.body = DisarmCommand{};
        break;
    case 2:
        command.body = StopCommand{};
        break;
    case 3:
        command.body = HeartbeatCommand{};
        break;
    case 4:
        command.body = SetLimitsCommand{random.number<std::int32_t>(), random.number<std::int32_t>()};
        break;
    case 5: {
        UploadCommand upload;
        upload.excitationNumber = random.number<std::uint16_t>();
        upload.offset = random.number<std::uint32_t>();
        upload.count = static_cast<std::uint8_t>(1 + random.below(maxForcesPerUpload));
        for (std::size_t i = 0; i < upload.count; ++i)
            upload.forces[i] = random.number<std::int32_t>();
        command.body = upload;
        break;
    }
    case 6:
        command.body = FinishCommand{random.number<std::uint16_t>()};
        break;
    default:
        command.body = StartCommand{random.number<std::uint16_t>(), random.number<std::uint32_t>(),
                                    random.number<std::uint16_t>()};
    }
    return command;
}

MeasurementFeature randomMeasurement(Random& random)
{
    MeasurementFeature feature;
    feature.forceUnit = static_cast<ForceUnit>(random.below(4));
    feature.positionUnit = static_cast<PositionUnit>(random.below(4));
    feature.forcePerCount = random.positive();
    feature.positionPerCount = random.positive();
    feature.sampleTime_s = random.positive();
    feature.forceLag_s = longestLag_s * (2 * random.positive() - 1);
    feature.hold = random.below(2) ? ForceHold::First : ForceHold::Zero;
    feature.commandable = random.below(2);
    feature.watchdog_ms = random.number<std::uint16_t>();
    return feature;
}

/// With the CRC put right again after a change.
Report sealed(Report report)
{
    const std::uint8_t version = report[1];
    seal(report);
    report[1] = version;
    const std::uint16_t crc = crc16(ReportView(report).first(reportSize - 2));
    report[reportSize - 2] = static_cast<std::uint8_t>(crc);
    report[reportSize - 1] = static_cast<std::uint8_t>(crc >> 8);
    return report;
}

/// What kept it from being understood; nothing where it was.
template <typename Message>
std::optional<DecodeError::Kind> kindOf(const Decoded<Message>& decoded)
{
    return decoded ? std::nullopt : std::optional(decoded.error().kind);
}

} // namespace

class ProtocolCodecTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsEncodedIsDecodedAgain()
    {
        Random random;
        for (int i = 0; i < 2000; ++i) {
            const StreamReport stream = randomStream(random);
            QVERIFY(decodeInput(encode(stream)) == InputMessage(stream));
            const Acknowledgement answer = randomAnswer(random);
            QVERIFY(decodeInput(encode(answer)) == InputMessage(answer));
            const Command command = randomCommand(random);
            QVERIFY(decodeCommand(encode(command)) == command);
            IdentityFeature identity;
            identity.serial = random.text(24);
            identity.firmware = random.text(10);
            identity.name = random.text(24);
            identity.protocolMinor = static_cast<std::uint8_t>(random.below(16));
            QVERIFY(decodeIdentity(encode(identity)) == identity);
            const MeasurementFeature measurement = randomMeasurement(random);
            QVERIFY(decodeMeasurement(encode(measurement)) == measurement);
            const LimitsFeature limits{random.number<std::int32_t>() & 0x7FFFFFFF,
                                       random.number<std::int32_t>() & 0x7FFFFFFF,
                                       random.number<std::uint32_t>()};
            QVERIFY(decodeLimits(encode(limits)) == limits);
        }
    }

    void anyFlippedBitIsNoticed()
    {
        Random random;
        const Report report = encode(randomStream(random));
        for (std::size_t bit = 0; bit < 8 * reportSize; ++bit) {
            Report damaged = report;
            damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << bit % 8));
            QVERIFY(kindOf(decodeInput(damaged)) == DecodeError::Crc);
        }
    }

    void anyOtherLengthIsRefused()
    {
        Random random;
        const Report report = encode(randomStream(random));
        std::vector<std::uint8_t> bytes(report.begin(), report.end());
        bytes.resize(128);
        for (std::size_t length = 0; length <= bytes.size(); ++length) {
            const auto decoded = decodeInput(ReportView(bytes).first(length));
            if (length == reportSize)
                QVERIFY(decoded.has_value());
            else
                QVERIFY(!decoded && decoded.error() == DecodeError(DecodeError::Length, length));
        }
    }

    void garbageIsNeverTakenForAReport()
    {
        Random random;
        for (int i = 0; i < 20000; ++i) {
            Report report;
            for (std::uint8_t& byte : report)
                byte = random.number<std::uint8_t>();
            if (crc16(ReportView(report).first(reportSize - 2)) == (report[62] | report[63] << 8))
                continue; // one in 65536 is right by chance
            QVERIFY(!decodeInput(report));
            QVERIFY(!decodeCommand(report));
            QVERIFY(!decodeIdentity(report));
        }
    }

    void fieldsOutsideTheirRangeAreRefused_data()
    {
        QTest::addColumn<int>("id");
        QTest::addColumn<int>("byte");
        QTest::addColumn<int>("value");
        QTest::newRow("six samples") << 0x01 << 17 << 6;
        QTest::newRow("unknown excitation state") << 0x01 << 16 << 5;
        QTest::newRow("unknown result") << 0x02 << 7 << 11;
        QTest::newRow("arm with a wrong key") << 0x20 << 4 << 0x40;
        QTest::newRow("no forces") << 0x25 << 6 << 0;
        QTest::newRow("13 forces") << 0x25 << 6 << 13;
        QTest::newRow("unknown force unit") << 0x11 << 2 << 4;
        QTest::newRow("unknown position unit") << 0x11 << 3 << 4;
        QTest::newRow("negative scale") << 0x11 << 15 << 0xBF;
        QTest::newRow("infinite scale") << 0x11 << 23 << 0x7F;
        QTest::newRow("negative limit") << 0x12 << 7 << 0x80;
    }
    void fieldsOutsideTheirRangeAreRefused()
    {
        QFETCH(int, id);
        QFETCH(int, byte);
        QFETCH(int, value);
        UploadCommand upload;
        upload.count = 3;
        MeasurementFeature measurement;
        measurement.sampleTime_s = 1;
        const std::vector<Report> reports{
            encode(StreamReport{}),     encode(Acknowledgement{}), encode(Command{1, ArmCommand{}}),
            encode(Command{1, upload}), encode(measurement),       encode(LimitsFeature{})};
        const auto found =
            std::find_if(reports.begin(), reports.end(), [&](const Report& r) { return r[0] == id; });
        QVERIFY(found != reports.end());
        Report report = *found;
        report[static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(value);
        if (value == 0x7F)
            report[static_cast<std::size_t>(byte) - 1] = 0xF0;
        report = sealed(report);
        const auto refused = [](const auto& decoded) { return kindOf(decoded) == DecodeError::BadField; };
        QVERIFY(refused(decodeInput(report)) || refused(decodeCommand(report)) ||
                refused(decodeMeasurement(report)) || refused(decodeLimits(report)));
    }

    void anotherMajorVersionIsRefusedAndAMinorOneIsNot()
    {
        Report report = encode(StreamReport{});
        report[1] = 0x1F;
        QVERIFY(decodeInput(sealed(report)).has_value());
        report[1] = 0x20;
        QVERIFY(decodeInput(sealed(report)).error() == DecodeError(DecodeError::Version, 0x20));
    }

    void aLongTextIsCutBetweenCharacters()
    {
        IdentityFeature identity;
        identity.serial.assign(23, 'x');
        identity.serial += "\xC3\xA4"; // 25 bytes; the last character has two
        const auto decoded = decodeIdentity(encode(identity));
        QCOMPARE(decoded->serial, std::string(23, 'x'));
    }
};

GRIPSCOPE_TEST(ProtocolCodecTest)
#include "protocol_codec_test.moc"
