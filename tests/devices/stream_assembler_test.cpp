// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/stream_assembler.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::protocol;
using Outcome = StreamAssembler::Outcome;

namespace {

/// Report number `index` of a stream of two samples a report that begins at the given counters.
StreamReport reportAt(std::uint32_t index, std::uint32_t report0 = 0, std::uint32_t sample0 = 0,
                      std::uint32_t time0 = 0)
{
    StreamReport report;
    report.reportSequence = report0 + index;
    report.firstSample = sample0 + 2 * index;
    report.timestamp_us = time0 + 1000 * index;
    report.count = 2;
    report.samples[0] = {static_cast<std::int32_t>(2 * index), 1};
    report.samples[1] = {static_cast<std::int32_t>(2 * index + 1), 2};
    return report;
}

StreamAssembler assembler()
{
    return {0.001, 20e-6, 0.0005};
}

} // namespace

class StreamAssemblerTest : public QObject {
    Q_OBJECT
private slots:
    void givesValuesInTheDevicesUnits()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        StreamReport report = reportAt(0, 5, 100, 2000);
        report.status = StatusArmed;
        report.samples[1] = {-3, 7};
        QVERIFY(stream.take(report, samples) == Outcome::Accepted);
        QCOMPARE(samples.size(), std::size_t(2));
        QCOMPARE(samples[0].sequence, std::uint64_t(100));
        QCOMPARE(samples[1].sequence, std::uint64_t(101));
        QCOMPARE(samples[0].time_s, 0.002);
        QCOMPARE(samples[1].time_s, 0.0025);
        QCOMPARE(samples[1].force, -0.003);
        QCOMPARE(samples[1].position, 7 * 20e-6);
        QCOMPARE(samples[1].status, std::uint16_t(StatusArmed));
    }

    void countsWhatIsLostAndKeepsTheGap()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        for (const std::uint32_t index : {0U, 1U, 4U, 5U})
            QVERIFY(stream.take(reportAt(index), samples) == Outcome::Accepted);
        QCOMPARE(stream.lostSamples(), std::uint64_t(4));
        QCOMPARE(stream.sequenceGaps(), std::uint64_t(1));
        QCOMPARE(stream.clockSteps(), std::uint64_t(0));
        QCOMPARE(samples.size(), std::size_t(8));
        QCOMPARE(samples[4].sequence, std::uint64_t(8));
        QCOMPARE(samples[4].time_s, 0.004);
    }

    void dropsDuplicates()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        for (const std::uint32_t index : {0U, 1U, 1U, 0U, 2U})
            static_cast<void>(stream.take(reportAt(index), samples));
        QCOMPARE(samples.size(), std::size_t(6));
        QCOMPARE(stream.duplicateReports(), std::uint64_t(2));
        QCOMPARE(stream.lostSamples(), std::uint64_t(0));
    }

    void goesOnWhenCountersWrap()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        for (std::uint32_t index = 0; index < 10; ++index)
            QVERIFY(stream.take(reportAt(index, 0xFFFFFFFC, 0xFFFFFFF7, 0xFFFFEC00), samples) ==
                    Outcome::Accepted);
        QCOMPARE(stream.lostSamples(), std::uint64_t(0));
        QCOMPARE(samples.front().sequence, std::uint64_t(0xFFFFFFF7));
        for (std::size_t i = 1; i < samples.size(); ++i) {
            QCOMPARE(samples[i].sequence, samples[i - 1].sequence + 1);
            QVERIFY(std::abs(samples[i].time_s - samples[i - 1].time_s - 0.0005) < 1e-9);
        }
    }

    void countsAcrossAWrapWithLoss()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        QVERIFY(stream.take(reportAt(0, 0xFFFFFFFF, 0xFFFFFFFE, 0xFFFFFFFF), samples) == Outcome::Accepted);
        QVERIFY(stream.take(reportAt(3, 0xFFFFFFFF, 0xFFFFFFFE, 0xFFFFFFFF), samples) == Outcome::Accepted);
        QCOMPARE(stream.lostSamples(), std::uint64_t(4));
        QCOMPARE(samples[2].sequence, std::uint64_t(0xFFFFFFFE) + 6);
    }

    void noticesADeviceThatBeginsAnew()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        QVERIFY(stream.take(reportAt(100000), samples) == Outcome::Accepted);
        QVERIFY(stream.take(reportAt(0), samples) == Outcome::Restarted);
        QCOMPARE(samples.size(), std::size_t(2));
    }

    void countsAClockThatIsSetForwardAndKeepsItsTime()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        for (const std::uint32_t index : {0U, 1U})
            QVERIFY(stream.take(reportAt(index), samples) == Outcome::Accepted);
        for (const std::uint32_t index : {2U, 3U})
            QVERIFY(stream.take(reportAt(index, 0, 0, 50000), samples) == Outcome::Accepted);
        QCOMPARE(stream.clockSteps(), std::uint64_t(1));
        QCOMPARE(stream.lostSamples(), std::uint64_t(0));
        QCOMPARE(samples[4].time_s, 0.052);
        for (std::size_t i = 0; i < samples.size(); ++i)
            QCOMPARE(samples[i].clockStepped, i == 4);
    }

    void countsAClockThatIsSetBackAndLetsNoTimeRunBackwards()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        for (const std::uint32_t index : {0U, 1U})
            QVERIFY(stream.take(reportAt(index, 0, 0, 50000), samples) == Outcome::Accepted);
        for (const std::uint32_t index : {2U, 3U, 4U})
            QVERIFY(stream.take(reportAt(index), samples) == Outcome::Accepted);
        QCOMPARE(stream.clockSteps(), std::uint64_t(1));
        QVERIFY(samples[4].clockStepped);
        for (std::size_t i = 1; i < samples.size(); ++i)
            QVERIFY(std::abs(samples[i].time_s - samples[i - 1].time_s - 0.0005) < 1e-9);
    }

    void takesJitterAndLostReportsForNoClockStep()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        for (std::uint32_t index = 0; index < 4000; index += index % 5 == 0 ? 40 : 1) {
            StreamReport report = reportAt(index);
            report.timestamp_us += index % 3 * 100; // 0.4 samples at the most
            QVERIFY(stream.take(report, samples) == Outcome::Accepted);
        }
        QVERIFY(stream.sequenceGaps() > 10);
        QCOMPARE(stream.clockSteps(), std::uint64_t(0));
    }

    void takesSampleNumbersThatRunBackwardsForADeviceThatBeginsAnew()
    {
        StreamAssembler stream = assembler();
        std::vector<Sample> samples;
        QVERIFY(stream.take(reportAt(10), samples) == Outcome::Accepted);
        StreamReport report = reportAt(11);
        report.firstSample = 3;
        QVERIFY(stream.take(report, samples) == Outcome::Restarted);
    }
};

GRIPSCOPE_TEST(StreamAssemblerTest)
#include "stream_assembler_test.moc"
