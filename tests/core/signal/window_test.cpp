// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/preparation_parts.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;

namespace {

/// A device's recording: status Moving from sample `first` to one before `end`, sequence numbers from 0.
Recording deviceRecording(std::size_t count, std::size_t first, std::size_t end)
{
    Recording recording;
    recording.sampleTime_s = 0.001;
    for (std::size_t i = 0; i < count; ++i) {
        recording.time_s.push_back(static_cast<double>(i) * 0.001);
        recording.force.push_back(1);
        recording.position.push_back(2);
        recording.sequence.push_back(i);
        recording.status.push_back(StatusArmed | (i >= first && i < end ? StatusMoving : 0));
    }
    return recording;
}

/// From sample `at` on, `lost` sequence numbers further.
void lose(Recording& recording, std::size_t at, std::uint64_t lost)
{
    for (std::size_t i = at; i < recording.size(); ++i) {
        recording.sequence[i] += lost;
        recording.time_s[i] += static_cast<double>(lost) * 0.001;
    }
}

} // namespace

class WindowTest : public QObject {
    Q_OBJECT
private slots:
    void withoutStatusEverythingIsEligible()
    {
        Recording recording = deviceRecording(100, 0, 0);
        recording.status.clear();
        const WindowChoice choice = chooseWindow(recording);
        QVERIFY((choice.window == Window{0, 100}));
        QCOMPARE(choice.eligible, std::size_t(100));
        QCOMPARE(choice.gaps, std::size_t(0));
    }
    void onlyTheMovingPartIsTaken()
    {
        const WindowChoice choice = chooseWindow(deviceRecording(100, 20, 70));
        QVERIFY((choice.window == Window{20, 50}));
        QCOMPARE(choice.eligible, std::size_t(50));
    }
    void withoutAnyMovingSampleEverythingIsEligible()
    {
        QVERIFY((chooseWindow(deviceRecording(100, 0, 0)).window == Window{0, 100}));
    }
    void aGapInsideIsCountedAndNeverInTheWindow()
    {
        Recording recording = deviceRecording(100, 20, 70);
        lose(recording, 60, 4);
        const WindowChoice choice = chooseWindow(recording);
        QVERIFY((choice.window == Window{20, 40}));
        QCOMPARE(choice.eligible, std::size_t(50));
        QCOMPARE(choice.lostSamples, std::int64_t(4));
        QCOMPARE(choice.gaps, std::size_t(1));
    }
    void gapsBeforeAndAfterTheMovingPartDoNotCount()
    {
        Recording recording = deviceRecording(100, 20, 70);
        lose(recording, 10, 2);
        lose(recording, 20, 2); // just before the first moving sample
        lose(recording, 70, 2);
        const WindowChoice choice = chooseWindow(recording);
        QVERIFY((choice.window == Window{20, 50}));
        QCOMPARE(choice.lostSamples, std::int64_t(0));
        QCOMPARE(choice.gaps, std::size_t(0));
    }
    void aPauseInTheMovementBreaksTheWindow()
    {
        Recording recording = deviceRecording(100, 20, 70);
        recording.status[30] = StatusArmed;
        const WindowChoice choice = chooseWindow(recording);
        QVERIFY((choice.window == Window{31, 39}));
        QCOMPARE(choice.eligible, std::size_t(49));
        QCOMPARE(choice.gaps, std::size_t(0));
    }
    void anEmptyRecordingGivesAnEmptyWindow()
    {
        QCOMPARE(chooseWindow(Recording()).window.count, std::size_t(0));
    }
};

GRIPSCOPE_TEST(WindowTest)
#include "window_test.moc"
