// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/modbus_registers.h"
#include "tests/support/test_registry.h"
#include "tests/support/text_file.h"

#include <QRegularExpression>
#include <QTest>

#include <bit>
#include <random>

using namespace gripscope;

namespace {

using RequestBytes = std::vector<std::uint8_t>;

float floatAt(const std::vector<std::uint16_t>& words, int address)
{
    const auto at = static_cast<std::size_t>(address - line_register::statusFirst);
    return std::bit_cast<float>((std::uint32_t(words[at]) << 16U) | words[at + 1]);
}

std::uint32_t pairAt(const std::vector<std::uint16_t>& words, int address)
{
    return std::bit_cast<std::uint32_t>(floatAt(words, address));
}

LineResult someResult()
{
    LineResult result;
    result.sequence = 0x10002;
    result.job = {7, 2, 0xDEADBEEF};
    result.state = ResultState::Completed;
    result.evaluation = ResultEvaluation::NotOk;
    result.reason = ResultReason::OtherType;
    result.typeFound = 1;
    result.simulated = true;
    result.quantities = {LineQuantity{0.0396, 1e-4}, std::nullopt, LineQuantity{9990, std::nullopt}};
    result.utc = QDateTime::fromMSecsSinceEpoch(1'700'000'000'123, Qt::UTC);
    return result;
}

} // namespace

class LineRegistersTest : public QObject {
    Q_OBJECT
private slots:
    void theChecksumIsThatOfModbus()
    {
        // "12345678" by the bitwise definition in another language, which gives 0x4B37 for "123456789", the
        // published check.
        const std::vector<std::uint16_t> digits{0x3132, 0x3334, 0x3536, 0x3738};
        QCOMPARE(registerChecksum(digits), std::uint16_t(0x37DD));
        QCOMPARE(registerChecksum({}), std::uint16_t(0xFFFF));
    }
    void aResultStandsInItsRegisters()
    {
        JobDesk::View view;
        view.result = someResult();
        view.unread = true;
        const std::vector<std::uint16_t> words = encodeView(view);
        QCOMPARE(int(words.size()), line_register::statusCount + line_register::resultCount);
        QCOMPARE(words[0], std::uint16_t(1));
        QCOMPARE(words[2], line_status_bit::resultValid);
        QCOMPARE(pairAt(words, 120), 0x10002U);
        QCOMPARE(pairAt(words, 122), 0xDEADBEEFU);
        QCOMPARE(words[124 - 100], std::uint16_t(7));
        QCOMPARE(words[126 - 100], std::uint16_t(2));
        QCOMPARE(words[127 - 100], std::uint16_t(2 | 4 | 16 | 32)); // simulated, m and k known, u(m) known
        QCOMPARE(floatAt(words, 130), 0.0396F);
        QCOMPARE(floatAt(words, 132), 1e-4F);
        QCOMPARE(floatAt(words, 134), 0.0F);
        QCOMPARE(floatAt(words, 138), 9990.0F);
        QCOMPARE(pairAt(words, 142), 1'700'000'000U);
        QCOMPARE(words[144 - 100], std::uint16_t(123));
        QCOMPARE(words.back(), registerChecksum(std::span(words).subspan(20, 27)));
    }
    void pairsAndJobsAreTakenWhole_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("taken");
        QTest::newRow("heartbeat") << 0 << 1 << true;
        QTest::newRow("acknowledge") << 1 << 2 << true;
        QTest::newRow("half an acknowledge") << 2 << 1 << false;
        QTest::newRow("job") << 4 << 4 << true;
        QTest::newRow("trigger alone") << 4 << 1 << false;
        QTest::newRow("job without its token's end") << 4 << 3 << false;
        QTest::newRow("all of a cycle") << 0 << 8 << true;
        QTest::newRow("result wanted") << 8 << 2 << true;
        QTest::newRow("half a result wanted") << 0 << 9 << false;
        QTest::newRow("all") << 0 << 10 << true;
    }
    void pairsAndJobsAreTakenWhole()
    {
        QFETCH(int, first);
        QFETCH(int, count);
        QFETCH(bool, taken);
        const std::vector<std::uint16_t> values(std::size_t(count), 3);
        QCOMPARE(decodeWrite(first, values).has_value(), taken);
    }
    void requestsAreAnswered_data()
    {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("answer");
        const auto row = [](const char* name, const char* request, const char* answer) {
            QTest::newRow(name) << QByteArray::fromHex(request) << QByteArray::fromHex(answer);
        };
        row("read the version", "03 0064 0001", "03 02 0001");
        row("the same by function 4", "04 0064 0001", "04 02 0001");
        row("write the heartbeat", "06 0000 0005", "06 0000 0005");
        row("write a job", "10 0004 0004 08 0001 0000 0000 0009", "10 0004 0004");
        row("write and read", "17 0068 0001 0004 0004 08 0001 0000 0000 0009", "17 02 0001");
        row("none is kept of 7", "17 00C8 0001 0008 0002 04 0000 0007", "17 02 0000");
        row("its checksum", "04 00E3 0001", "04 02 1118"); // as below
        row("beyond it", "04 00E3 0002", "84 02");
        row("between the blocks", "04 00C7 0002", "84 02");
        row("none", "04 0064 0000", "84 03");
        row("too many", "04 0064 007E", "84 03");
        row("not there", "04 0010 0001", "84 02");
        row("beyond", "04 0093 0002", "84 02");
        row("the last", "04 0093 0001", "04 02 1118"); // of 27 registers of zero
        row("written to what is read", "06 0064 0001", "86 02");
        row("part of a job", "06 0004 0001", "86 03");
        row("fewer bytes than said", "10 0004 0004 08 0001", "90 03");
        row("more bytes than said", "06 0000 0005 00", "86 03");
        row("unknown function", "08 0000 0004", "88 01");
    }
    void requestsAreAnswered()
    {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, answer);
        LineRegisters registers(std::make_shared<SharedJobDesk>(1));
        const RequestBytes bytes(request.begin(), request.end());
        const RequestBytes answered = answerPdu(bytes, registers);
        QCOMPARE(
            QByteArray(reinterpret_cast<const char*>(answered.data()), qsizetype(answered.size())).toHex(' '),
            answer.toHex(' '));
    }
    void anEarlierResultIsGivenByItsNumber()
    {
        const auto desk = std::make_shared<SharedJobDesk>(1);
        LineRegisters registers(desk);
        constexpr int results = int(JobDesk::mostKept) + 6;
        desk->with([](JobDesk& jobs) {
            jobs.setStation({LineState::Ready, true, true, 1});
            for (int i = 1; i <= results; ++i) {
                const auto now = std::chrono::steady_clock::now();
                jobs.beat(std::uint16_t(i), now);
                jobs.startSingleJob({std::uint16_t(i), 1, 1000U + std::uint32_t(i)}, now);
                jobs.finish(someResult(), now);
                if (i < results) // the last one is unread
                    QVERIFY(jobs.releaseResult(std::uint32_t(i)));
            }
        });
        using namespace line_register;
        const auto give = [&](std::uint32_t sequence) {
            const std::array words{std::uint16_t(sequence >> 16U), std::uint16_t(sequence)};
            if (registers.write(wanted, words))
                qFatal("it cannot be asked for");
            std::vector<std::uint16_t> block(resultCount);
            if (registers.read(wantedFirst, block))
                qFatal("it cannot be read");
            return block;
        };
        LineResult expected = someResult();
        for (const int i : {7, 30, results}) { // the oldest that is kept, a released one, the unread one
            expected.sequence = std::uint32_t(i);
            expected.job = {std::uint16_t(i), 1, 1000U + std::uint32_t(i)};
            QCOMPARE(give(expected.sequence), encodeResult(expected));
        }
        for (const std::uint32_t none : {0U, 6U, std::uint32_t(results) + 1, 0x10007U})
            QCOMPARE(give(none), encodeResult({}));
        // Asking releases nothing.
        QVERIFY(desk->with([](const JobDesk& jobs) { return jobs.view({}).unread; }));
    }
    void whateverComesIsReadWithinItsBytes()
    {
        std::mt19937 random(3);
        LineRegisters registers(std::make_shared<SharedJobDesk>(1));
        for (int i = 0; i < 200'000; ++i) {
            RequestBytes stream(random() % 40);
            for (std::uint8_t& byte : stream)
                byte = static_cast<std::uint8_t>(random() % (random() % 2 ? 256 : 24));
            if (stream.size() > 6 && random() % 2) {
                stream[2] = stream[3] = stream[4] = 0;
                stream[5] = static_cast<std::uint8_t>(random() % 40);
            }
            ModbusFrame frame;
            if (nextFrame(stream, frame) != FrameState::Whole)
                continue;
            QVERIFY(frame.bytes <= stream.size());
            QVERIFY(framed(frame, answerPdu(frame.pdu, registers)).size() <= 260);
        }
    }
    /// "| 104 | last trigger | uint16 | ...": every register of the manual is one of the code, in its order.
    void theManualHasTheseRegisters_data()
    {
        QTest::addColumn<QString>("page");
        QTest::newRow("English") << QStringLiteral("resources/manual/plant.md");
        QTest::newRow("German") << QStringLiteral("resources/manual/de/plant.md");
    }
    void theManualHasTheseRegisters()
    {
        QFETCH(QString, page);
        const QString text = test::textOf(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/") + page);
        const QRegularExpression row(
            QStringLiteral("^\\| (\\d+)(?: to \\d+| bis \\d+)? \\| `([^`]+)` \\| (\\w+) \\|"),
            QRegularExpression::MultilineOption);
        QStringList found, expected;
        for (auto i = row.globalMatch(text); i.hasNext();) {
            const QRegularExpressionMatch match = i.next();
            found << match.captured(1) + u' ' + match.captured(2) + u' ' + match.captured(3);
        }
        for (const RegisterField& field : registerFields())
            expected << QStringLiteral("%1 %2 %3")
                            .arg(QString::number(field.address), QLatin1String(field.name),
                                 QLatin1String(toString(field.type)));
        QCOMPARE(found, expected);
        for (const auto& [number, name] : {std::pair{1, LineState::Initialized},
                                           std::pair{2, LineState::Ready}, std::pair{5, LineState::Halted}})
            QVERIFY(text.contains(QStringLiteral("%1 %2").arg(QString::number(number), toString(name))));
    }
};

GRIPSCOPE_TEST(LineRegistersTest)
#include "line_registers_test.moc"
