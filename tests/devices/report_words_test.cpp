// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/report_log.h"
#include "devices/protocol/codec.h"
#include "devices/protocol/descriptor_words.h"
#include "devices/protocol/report_descriptor.h"
#include "devices/protocol/report_words.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <thread>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace Qt::StringLiterals;

namespace {

QString field(const ReportWords& words, const QString& name)
{
    for (const FieldWords& f : words.fields)
        if (f.name == name)
            return f.value;
    return u"no such field"_s;
}

} // namespace

class ReportWordsTest : public QObject {
    Q_OBJECT
private slots:
    void aStreamReportIsReadFieldByField()
    {
        StreamReport stream;
        stream.status = StatusArmed | StatusForceSaturated;
        stream.reportSequence = 77;
        stream.firstSample = 154;
        stream.timestamp_us = 3000500;
        stream.excitation = ExcitationState::Running;
        stream.excitationNumber = 8;
        stream.count = 2;
        stream.samples[1] = {-8, 617};
        const ReportWords words = reportInWords(encode(stream));
        QCOMPARE(words.kind, u"Stream"_s);
        QVERIFY(words.problem.isEmpty());
        QCOMPARE(field(words, u"status"_s), u"armed, force saturated"_s);
        QCOMPARE(field(words, u"device time"_s), u"3.000500 s"_s);
        QCOMPARE(field(words, u"excitation"_s), u"running, number 8"_s);
        QCOMPARE(field(words, u"sample 2"_s), u"force -8, position 617 counts"_s);
        QCOMPARE(field(words, u"sample 3"_s), u"no such field"_s);
    }

    void everyKindOfReportHasItsName()
    {
        const std::vector<CommandBody> bodies{ArmCommand{},           DisarmCommand{},
                                              StopCommand{},          HeartbeatCommand{},
                                              SetLimitsCommand{1, 2}, UploadCommand{3, 4, 1, {}},
                                              StartCommand{5, 6, 7},  FinishCommand{8}};
        QStringList kinds;
        for (const CommandBody& body : bodies) {
            const ReportWords words = reportInWords(encode(Command{600, body}));
            QVERIFY(words.problem.isEmpty());
            QCOMPARE(field(words, u"number"_s), u"600"_s);
            kinds << words.kind;
        }
        QCOMPARE(kinds.join(u", "_s), u"Arm, Disarm, Stop, Heartbeat, Set limits, Upload, Start, Finish"_s);
        QCOMPARE(field(reportInWords(encode(Command{1, ArmCommand{0x5EED}})), u"token"_s), u"0x00005eed"_s);
        QCOMPARE(field(reportInWords(encode(Command{1, ArmCommand{}})), u"token"_s), u"none"_s);
        IdentityFeature identity;
        identity.serial = "GS-7";
        QCOMPARE(field(reportInWords(encode(identity)), u"serial number"_s), u"GS-7"_s);
        MeasurementFeature measurement;
        measurement.sampleTime_s = 0.0005;
        QCOMPARE(field(reportInWords(encode(measurement)), u"sample time"_s), u"0.0005 s"_s);
        QCOMPARE(field(reportInWords(encode(LimitsFeature{100, 200, 300})), u"longest travel"_s),
                 u"200 counts"_s);
        Acknowledgement answer;
        answer.command = ReportId::Upload;
        answer.commandNumber = 513;
        answer.result = CommandResult::LimitExceeded;
        answer.detail = 24;
        QCOMPARE(field(reportInWords(encode(answer)), u"command"_s), u"Upload, number 513"_s);
        QCOMPARE(field(reportInWords(encode(answer)), u"result"_s),
                 u"force 24 of the signal is above the limit"_s);
    }

    void whatIsDamagedSaysSo()
    {
        Report report = encode(Command{1, StopCommand{}});
        report[5] ^= 1;
        QCOMPARE(reportInWords(report).kind, u"Stop"_s);
        QCOMPARE(reportInWords(report).problem, u"the checksum differs"_s);
        QVERIFY(reportInWords(report).fields.empty());
        QVERIFY(!reportInWords({}).problem.isEmpty());
        QVERIFY(reportInWords(ReportView(report).first(3)).problem.contains(u"64 bytes"_s));
        report[0] = 0x7F;
        QCOMPARE(reportInWords(report).kind, u"unknown report 0x7f"_s);
    }

    void theReportDescriptorIsReadItemByItem()
    {
        const std::vector<std::uint8_t> bytes = reportDescriptor();
        const std::vector<DescriptorItem> items = descriptorInWords(bytes);
        QCOMPARE(items[0].words, u"Usage page 0xff00 (vendor-defined)"_s);
        QCOMPARE(items[2].words, u"Collection: application"_s);
        QCOMPARE(items[3].words, u"Logical minimum 0"_s);
        QCOMPARE(items[4].words, u"Logical maximum 255"_s);
        QCOMPARE(items[5].words, u"Report size 8 bits"_s);
        QCOMPARE(items[6].words, u"Report count 63"_s);
        QCOMPARE(items[7].words, u"Report ID 0x01 (Stream)"_s);
        QCOMPARE(items[7].depth, 1);
        QCOMPARE(items[9].words, u"Input: data, variable, absolute"_s);
        QCOMPARE(items.back().words, u"End of collection"_s);
        QCOMPARE(items.back().depth, 0);
        QStringList hex;
        for (const DescriptorItem& item : items)
            hex << item.hex;
        QCOMPARE(hex.join(u' '), hexDump(bytes).replace(u'\n', u' '));
    }

    void anyBytesAreADescriptor()
    {
        for (int seed = 0; seed < 2000; ++seed) {
            std::vector<std::uint8_t> bytes;
            for (int i = 0; i < seed % 40; ++i)
                bytes.push_back(static_cast<std::uint8_t>((seed + 1) * 2654435761U >> (i % 24)));
            qsizetype seen = 0;
            for (const DescriptorItem& item : descriptorInWords(bytes))
                seen += (item.hex.size() + 1) / 3;
            QCOMPARE(seen, qsizetype(bytes.size()));
        }
        const std::uint8_t cut[] = {0x26, 0xFF};
        QCOMPARE(descriptorInWords(cut).back().words, u"cut short: 1 bytes are missing"_s);
    }

    void theLogKeepsTheLastReportsInOrder()
    {
        ReportLog log;
        const Report report = encode(Command{1, StopCommand{}});
        for (int i = 0; i < 300; ++i)
            log.add(i % 2 == 0 ? ReportDirection::In : ReportDirection::Out, report, i != 299);
        const std::vector<LoggedReport> last = log.last();
        QCOMPARE(last.size(), ReportLog::capacity);
        QCOMPARE(last.front().number, std::uint64_t(44));
        QCOMPARE(last.back().number, std::uint64_t(299));
        QVERIFY(!last.back().taken && last.front().taken);
        QVERIFY(std::equal(report.begin(), report.end(), last.back().view().begin()));
        QCOMPARE(log.missed(), std::uint64_t(0));
    }

    void whoLooksNeverHoldsUpWhoReads()
    {
        ReportLog log;
        const Report report = encode(Command{1, StopCommand{}});
        std::atomic<bool> done{false};
        std::thread looker([&] {
            while (!done)
                (void)log.last();
        });
        constexpr std::uint64_t all = 100000;
        for (std::uint64_t i = 0; i < all; ++i)
            log.add(ReportDirection::In, report);
        done = true;
        looker.join();
        // What passed while someone looked is not kept, but its number is told.
        const std::vector<LoggedReport> last = log.last();
        for (std::size_t i = 1; i < last.size(); ++i)
            QVERIFY(last[i].number > last[i - 1].number);
        QVERIFY(log.missed() < all);
    }
};

GRIPSCOPE_TEST(ReportWordsTest)
#include "report_words_test.moc"
