// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <numeric>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// `count` samples at 1 kHz, time = index / 1000, force = index, position = -index.
Recording countingRecording(std::size_t count)
{
    Recording recording;
    recording.sampleTime_s = 0.001;
    for (std::size_t i = 0; i < count; ++i) {
        recording.time_s.push_back(static_cast<double>(i) * 0.001);
        recording.force.push_back(static_cast<double>(i));
        recording.position.push_back(-static_cast<double>(i));
    }
    return recording;
}

Recording without(const Recording& all, std::size_t first, std::size_t count)
{
    Recording recording = all;
    const auto cut = [&](auto& values) {
        if (!values.empty())
            values.erase(values.begin() + static_cast<std::ptrdiff_t>(first),
                         values.begin() + static_cast<std::ptrdiff_t>(first + count));
    };
    cut(recording.time_s);
    cut(recording.force);
    cut(recording.position);
    cut(recording.sequence);
    cut(recording.status);
    return recording;
}

void number(Recording& recording)
{
    recording.sequence.resize(recording.size());
    std::iota(recording.sequence.begin(), recording.sequence.end(), std::uint64_t(100));
}

} // namespace

class RecordingTest : public QObject {
    Q_OBJECT
private slots:
    void aWholeRecordingHasNoGap()
    {
        const Recording recording = countingRecording(50);
        QVERIFY(findGaps(recording).empty());
        QVERIFY(findGaps(Recording()).empty());
    }
    void lostSamplesAreCountedFromTheTime()
    {
        const Recording recording = without(countingRecording(50), 20, 3);
        QVERIFY((findGaps(recording) == std::vector<Gap>{{20, 3}}));
    }
    void lostSamplesAreCountedFromTheSequenceWhereThereIsOne()
    {
        Recording recording = countingRecording(50);
        number(recording);
        recording = without(recording, 10, 1);
        recording = without(recording, 30, 5);
        QVERIFY((findGaps(recording) == std::vector<Gap>{{10, 1}, {30, 5}}));
    }
    void jitterOfTheClockIsNoGap()
    {
        Recording recording = countingRecording(50);
        for (std::size_t i = 0; i < recording.size(); i += 2)
            recording.time_s[i] += 0.0002;
        QVERIFY(findGaps(recording).empty());
    }
    void aSequenceThatJumpsBackIsAGapWithoutInventedLosses()
    {
        Recording recording = countingRecording(10);
        number(recording);
        for (std::size_t i = 4; i < 10; ++i)
            recording.sequence[i] = i - 4; // the device started again
        QVERIFY((findGaps(recording) == std::vector<Gap>{{4, 0}}));
    }
    void anAbsurdJumpInTimeStaysACount()
    {
        Recording recording = countingRecording(4);
        recording.time_s[3] = 1e300;
        const std::vector<Gap> gaps = findGaps(recording);
        QCOMPARE(gaps.size(), std::size_t(1));
        QVERIFY(gaps[0].lostSamples > 0);
    }
    void aSliceKeepsWhatBelongsToTheRecording()
    {
        Recording recording = countingRecording(30);
        number(recording);
        recording.status.assign(30, StatusArmed);
        recording.forceUnit = u"N"_s;
        recording.positionUnit = u"mm"_s;
        recording.hold = ForceHold::Zero;
        recording.forceLag_s = 1e-4;
        recording.chain.frameCompliance = 1e-5;
        recording.provenance.insert(u"operator"_s, u"Ada"_s);
        const Recording part = slice(recording, {10, 5});
        QCOMPARE(part.size(), std::size_t(5));
        QCOMPARE(part.force.front(), 10.0);
        QCOMPARE(part.position.back(), -14.0);
        QCOMPARE(part.sequence.front(), std::uint64_t(110));
        QCOMPARE(part.status.size(), std::size_t(5));
        QVERIFY(part.hold == ForceHold::Zero);
        QCOMPARE(part.forceLag_s, 1e-4);
        QVERIFY(part.chain == recording.chain);
        QCOMPARE(part.positionUnit, u"mm"_s);
        QCOMPARE(part.provenance, recording.provenance);
    }
    void aSliceBeyondTheEndIsCut()
    {
        QCOMPARE(slice(countingRecording(10), {8, 10}).size(), std::size_t(2));
        QCOMPARE(slice(countingRecording(10), {20, 10}).size(), std::size_t(0));
    }
    void theHoldReadsBackFromItsName()
    {
        for (const ForceHold hold : {ForceHold::Zero, ForceHold::First})
            QVERIFY(forceHoldFromString(toString(hold)) == hold);
        QVERIFY(!forceHoldFromString(u"spline"_s));
    }
};

GRIPSCOPE_TEST(RecordingTest)
#include "recording_test.moc"
