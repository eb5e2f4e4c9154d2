// SPDX-License-Identifier: GPL-3.0-or-later
// The header for firmware, compiled as C11, against the program's own codec: the same bytes both ways.
#include "devices/protocol/arming_obstacle.h"
#include "devices/protocol/codec.h"
#include "devices/protocol/report_descriptor.h"
#include "devices/virtual/virtual_firmware.h"
#include "tests/devices/firmware/compiled_header.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace gripscope;
using namespace gripscope::protocol;

namespace {

constexpr int draws = 500;

/// Numbers of all sizes, the ends of their ranges among them.
class Draw {
public:
    template <typename T>
    T number()
    {
        const std::uint64_t bits = m_engine();
        switch (m_engine() % 4) {
        case 0:
            return std::numeric_limits<T>::max();
        case 1:
            return std::numeric_limits<T>::min();
        default:
            return static_cast<T>(bits);
        }
    }
    std::uint8_t below(unsigned end) { return static_cast<std::uint8_t>(m_engine() % end); }

private:
    std::mt19937_64 m_engine{11};
};

StreamReport drawStream(Draw& draw)
{
    StreamReport stream;
    stream.status = draw.number<std::uint16_t>();
    stream.reportSequence = draw.number<std::uint32_t>();
    stream.firstSample = draw.number<std::uint32_t>();
    stream.timestamp_us = draw.number<std::uint32_t>();
    stream.excitation = static_cast<ExcitationState>(draw.below(5));
    stream.excitationNumber = draw.number<std::uint16_t>();
    stream.count = draw.below(6);
    for (std::size_t i = 0; i < stream.count; ++i)
        stream.samples[i] = {draw.number<std::int32_t>(), draw.number<std::int32_t>()};
    return stream;
}

gripscope_stream toC(const StreamReport& stream)
{
    gripscope_stream out{};
    out.status = stream.status;
    out.report_sequence = stream.reportSequence;
    out.first_sample = stream.firstSample;
    out.time_us = stream.timestamp_us;
    out.excitation_state = static_cast<std::uint8_t>(stream.excitation);
    out.excitation = stream.excitationNumber;
    out.sample_count = stream.count;
    for (std::size_t i = 0; i < stream.count; ++i)
        out.samples[i] = {stream.samples[i].force, stream.samples[i].position};
    return out;
}

/// What the header reads out of a command that the program sends.
gripscope_command readBack(const CommandBody& body, std::uint16_t number)
{
    const Report report = encode(Command{number, body});
    gripscope_command command{};
    const gripscope_reading reading = compiled_command(report.data(), report.size(), &command);
    return reading == GRIPSCOPE_OBEY ? command : gripscope_command{};
}

} // namespace

class FirmwareHeaderTest : public QObject {
    Q_OBJECT
private slots:
    void theDescriptorAndTheChecksumAreTheSame()
    {
        std::vector<std::uint8_t> bytes(200);
        bytes.resize(compiled_descriptor(bytes.data(), bytes.size()));
        QVERIFY(bytes == reportDescriptor());
        const char* const text = "123456789";
        QCOMPARE(int(compiled_crc16(reinterpret_cast<const std::uint8_t*>(text), 9)), 0x29B1);
        const std::vector<std::int32_t> forces{30000, 0, -1, 2147483647};
        QCOMPARE(compiled_forces_crc(forces.data(), forces.size()), forcesCrc(forces));
    }
    void streamReportsAreTheSameBytes()
    {
        Draw draw;
        for (int i = 0; i < draws; ++i) {
            const StreamReport stream = drawStream(draw);
            const gripscope_stream c = toC(stream);
            Report report;
            report.fill(0xAA); // what was there before must not stay
            compiled_stream(report.data(), &c);
            QVERIFY(report == encode(stream));
        }
    }
    void acknowledgementsAreTheSameBytes()
    {
        Draw draw;
        for (int i = 0; i < draws; ++i) {
            Acknowledgement answer;
            answer.status = draw.number<std::uint16_t>();
            answer.commandNumber = draw.number<std::uint16_t>();
            answer.command = static_cast<ReportId>(draw.number<std::uint8_t>());
            answer.result = static_cast<CommandResult>(draw.below(11));
            answer.detail = draw.number<std::uint32_t>();
            answer.timestamp_us = draw.number<std::uint32_t>();
            answer.excitation = static_cast<ExcitationState>(draw.below(5));
            answer.excitationNumber = draw.number<std::uint16_t>();
            const gripscope_acknowledgement c{answer.status,
                                              answer.commandNumber,
                                              static_cast<std::uint8_t>(answer.command),
                                              static_cast<std::uint8_t>(answer.result),
                                              answer.detail,
                                              answer.timestamp_us,
                                              static_cast<std::uint8_t>(answer.excitation),
                                              answer.excitationNumber};
            Report report{};
            compiled_acknowledgement(report.data(), &c);
            QVERIFY(report == encode(answer));
        }
    }
    void featuresAreTheSameBytes()
    {
        Report report{};
        const IdentityFeature identity{"GS-000042", "1.2.0", "Bench gripper"};
        const gripscope_identity names{"GS-000042", "1.2.0", "Bench gripper"};
        compiled_identity(report.data(), &names);
        QVERIFY(report == encode(identity));
        const gripscope_identity longer{"0123456789012345678901234", "12345678901", ""};
        compiled_identity(report.data(), &longer);
        QVERIFY(decodeIdentity(report)->serial == "012345678901234567890123");
        QVERIFY(decodeIdentity(report)->firmware == "1234567890");

        MeasurementFeature measured;
        measured.positionUnit = PositionUnit::Micrometre;
        measured.forcePerCount = 0.001;
        measured.positionPerCount = 2e-5;
        measured.sampleTime_s = 0.0005;
        measured.forceLag_s = -1e-4 / 3;
        measured.hold = ForceHold::First;
        measured.commandable = true;
        measured.watchdog_ms = 100;
        const gripscope_measurement c{1, 3, true, true, 100, 0.001, 2e-5, 0.0005, -1e-4 / 3};
        compiled_measurement(report.data(), &c);
        QVERIFY(report == encode(measured));
        const gripscope_limits limits{100000, 1250, 32768};
        compiled_limits(report.data(), &limits);
        QVERIFY(report == encode(LimitsFeature{100000, 1250, 32768}));
    }
    void commandsAreUnderstood()
    {
        QCOMPARE(int(readBack(ArmCommand{}, 511).id), int(GRIPSCOPE_ARM));
        QCOMPARE(readBack(ArmCommand{}, 511).number, std::uint16_t(511));
        QCOMPARE(readBack(ArmCommand{}, 511).token, 0u);
        QCOMPARE(readBack(ArmCommand{0x2C81F96B}, 511).token, 0x2C81F96Bu);
        QCOMPARE(int(readBack(DisarmCommand{}, 1).id), int(GRIPSCOPE_DISARM));
        QCOMPARE(int(readBack(StopCommand{}, 1).id), int(GRIPSCOPE_STOP));
        QCOMPARE(int(readBack(HeartbeatCommand{}, 1).id), int(GRIPSCOPE_HEARTBEAT));
        const gripscope_command limits = readBack(SetLimitsCommand{50000, 400}, 2);
        QCOMPARE(limits.max_force, 50000);
        QCOMPARE(limits.max_travel, 400);
        const gripscope_command upload = readBack(UploadCommand{8, 12, 3, {30000, -10000, 30000}}, 3);
        QCOMPARE(upload.excitation, std::uint16_t(8));
        QCOMPARE(upload.first, 12u);
        QCOMPARE(int(upload.force_count), 3);
        QCOMPARE(upload.forces[1], -10000); // whether it may push so hard, or pull, is the device's to say
        QCOMPARE(upload.forces[3], 0);
        const gripscope_command start = readBack(StartCommand{8, 15, 0x35C2}, 4);
        QCOMPARE(start.samples, 15u);
        QCOMPARE(int(start.forces_crc), 0x35C2);
        QCOMPARE(start.excitation, std::uint16_t(8));
        QCOMPARE(int(readBack(FinishCommand{8}, 5).id), int(GRIPSCOPE_FINISH));
        QCOMPARE(readBack(FinishCommand{8}, 5).excitation, std::uint16_t(8));
    }
    void whatIsDamagedIsDropped()
    {
        const Report good = encode(Command{77, SetLimitsCommand{50000, 400}});
        gripscope_command command{};
        for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
            Report report = good;
            report[bit / 8] = static_cast<std::uint8_t>(report[bit / 8] ^ 1u << bit % 8);
            QCOMPARE(compiled_command(report.data(), report.size(), &command), GRIPSCOPE_DROP);
            QCOMPARE(int(command.number), 0);
        }
        QCOMPARE(compiled_command(good.data(), good.size() - 1, &command), GRIPSCOPE_DROP);
        QCOMPARE(compiled_command(good.data(), 0, &command), GRIPSCOPE_DROP);
    }
    void whatIsWrongInAWholeReportIsAnswered()
    {
        const auto reading = [](Report report, std::size_t at, std::uint8_t byte, std::uint16_t& number) {
            report[at] = byte;
            const std::uint16_t crc = crc16(ReportView(report).first(62));
            report[62] = static_cast<std::uint8_t>(crc);
            report[63] = static_cast<std::uint8_t>(crc >> 8);
            gripscope_command command{};
            const gripscope_reading result = compiled_command(report.data(), report.size(), &command);
            number = command.number;
            return result;
        };
        std::uint16_t number = 0;
        QCOMPARE(reading(encode(Command{9, ArmCommand{}}), 0, 0x2F, number), GRIPSCOPE_ANSWER_UNKNOWN);
        QCOMPARE(int(number), 9);
        QCOMPARE(reading(encode(Command{9, ArmCommand{}}), 4, 'a', number), GRIPSCOPE_ANSWER_BAD);
        QCOMPARE(reading(encode(Command{9, UploadCommand{1, 0, 1, {5}}}), 6, 0, number),
                 GRIPSCOPE_ANSWER_BAD);
        QCOMPARE(reading(encode(Command{9, UploadCommand{1, 0, 1, {5}}}), 6, 13, number),
                 GRIPSCOPE_ANSWER_BAD);
        QCOMPARE(reading(encode(Command{9, SetLimitsCommand{1, 1}}), 4, 0, number), GRIPSCOPE_ANSWER_BAD);
        QCOMPARE(reading(encode(Command{9, StopCommand{}}), 1, 0x20, number), GRIPSCOPE_DROP); // version 2
        for (const std::uint8_t version : {0x10, 0x11, 0x1F}) // a newer minor only adds
            QCOMPARE(reading(encode(Command{9, StopCommand{}}), 1, version, number), GRIPSCOPE_OBEY);
    }
    void refusedLimitsSayWhichOfThem()
    {
        const auto detail = [](std::int32_t force, std::int32_t travel) {
            const Report report = encode(Command{1, SetLimitsCommand{force, travel}});
            gripscope_command command{};
            compiled_command(report.data(), report.size(), &command);
            return command.bad_detail;
        };
        QCOMPARE(detail(1, 1), 0u);
        QCOMPARE(detail(0, 1), std::uint32_t(GRIPSCOPE_DETAIL_FORCE));
        QCOMPARE(detail(1, -1), std::uint32_t(GRIPSCOPE_DETAIL_TRAVEL));
        QCOMPARE(detail(-1, -1), limitsDetailForce);
        QCOMPARE(std::uint32_t(GRIPSCOPE_DETAIL_TRAVEL), limitsDetailTravel);
    }
    void theRangesAreThoseOfTheProgram()
    {
        QCOMPARE(int(GRIPSCOPE_WATCHDOG_MIN_MS), int(shortestWatchdog_ms));
        QCOMPARE(int(GRIPSCOPE_WATCHDOG_MAX_MS), int(longestWatchdog_ms));
        QCOMPARE(double(GRIPSCOPE_LONGEST_REPORT_PERIOD_MS) / 1000, longestReportPeriod_s);
        QCOMPARE(GRIPSCOPE_PER_COUNT_MIN, leastPerCount);
        QCOMPARE(GRIPSCOPE_PER_COUNT_MAX, mostPerCount);
        QCOMPARE(GRIPSCOPE_SAMPLE_TIME_MIN_S, shortestSampleTime_s);
        QCOMPARE(GRIPSCOPE_SAMPLE_TIME_MAX_S, longestSampleTime_s);
        QCOMPARE(GRIPSCOPE_LAG_MAX_S, longestLag_s);
        QCOMPARE(int(GRIPSCOPE_SAMPLES_ABOVE_LIMIT), VirtualFirmware::samplesBeyond);
        QCOMPARE(int(GRIPSCOPE_PROTOCOL_VERSION), versionMajor << 4 | versionMinor);
    }
    void anArmIsAnsweredByItsToken_data()
    {
        QTest::addColumn<unsigned>("token");
        QTest::addColumn<unsigned>("last");
        QTest::addColumn<bool>("fault");
        QTest::addColumn<bool>("armed");
        QTest::addColumn<int>("answer");
        QTest::addColumn<unsigned>("kept");
        const auto row = [](const char* name, unsigned token, unsigned last, bool fault, bool armed,
                            int answer, unsigned kept) {
            QTest::newRow(name) << token << last << fault << armed << answer << kept;
        };
        row("the first", 7, 0, false, false, GRIPSCOPE_DONE, 7);
        row("repeated while armed", 7, 7, false, true, GRIPSCOPE_REPEATED, 7);
        row("repeated after a stop", 7, 7, false, false, GRIPSCOPE_REPEATED, 7);
        row("repeated in a fault", 7, 7, true, false, GRIPSCOPE_REPEATED, 7);
        row("another while armed is remembered", 8, 7, false, true, GRIPSCOPE_REPEATED, 8);
        row("another after a stop", 8, 7, false, false, GRIPSCOPE_DONE, 8);
        row("another in a fault is not remembered", 8, 7, true, false, GRIPSCOPE_FAULT, 7);
        row("without a token", 0, 7, false, false, GRIPSCOPE_DONE, 7);
        row("without a token, again", 0, 0, false, false, GRIPSCOPE_DONE, 0);
        row("without a token, armed", 0, 7, false, true, GRIPSCOPE_REPEATED, 7);
        row("without a token, in a fault", 0, 7, true, false, GRIPSCOPE_FAULT, 7);
    }
    void anArmIsAnsweredByItsToken()
    {
        QFETCH(unsigned, token);
        QFETCH(unsigned, last);
        QFETCH(bool, fault);
        QFETCH(bool, armed);
        QFETCH(int, answer);
        QFETCH(unsigned, kept);
        std::uint32_t remembered = last;
        QCOMPARE(int(compiled_answer_arm(token, &remembered, fault, armed)), answer);
        QCOMPARE(remembered, kept);
    }
    void onlyACommandThatWasTakenFeedsTheWatchdog()
    {
        for (int id = 0; id < 0x30; ++id)
            for (int result = GRIPSCOPE_DONE; result <= GRIPSCOPE_FAULT; ++result) {
                const bool taken =
                    result == GRIPSCOPE_DONE || (result == GRIPSCOPE_REPEATED && id != GRIPSCOPE_ARM);
                const bool known = id >= GRIPSCOPE_ARM && id <= GRIPSCOPE_FINISH;
                const bool ends = id == GRIPSCOPE_STOP || id == GRIPSCOPE_DISARM;
                QCOMPARE(compiled_feeds_watchdog(std::uint8_t(id), std::uint8_t(result)),
                         taken && known && !ends);
            }
    }
    void theProtectiveForceIsAboveTheLimitByWhatIsStated()
    {
        QCOMPARE(compiled_protective_force(30000, 100000), std::int64_t(32500));
        QCOMPARE(compiled_protective_force(19, 99), std::int64_t(19)); // fractions of a count are left out
        QCOMPARE(compiled_protective_force(0x7FFFFFFF, 0x7FFFFFFF),
                 std::int64_t(0x7FFFFFFF) + 0x7FFFFFFF / 20 + 0x7FFFFFFF / 100);
    }
};

GRIPSCOPE_TEST(FirmwareHeaderTest)
#include "firmware_header_test.moc"
