// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/feed/live_history.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;

namespace {

constexpr double sampleTime_s = 0.0005;

std::vector<Sample> ramp(double from_s, double to_s, double peakAt_s = -1)
{
    std::vector<Sample> samples;
    const auto first = static_cast<std::uint64_t>(std::llround(from_s / sampleTime_s));
    const auto last = static_cast<std::uint64_t>(std::llround(to_s / sampleTime_s));
    for (std::uint64_t i = first; i < last; ++i) {
        Sample s;
        s.sequence = i;
        s.time_s = static_cast<double>(i) * sampleTime_s;
        s.force = std::sin(s.time_s);
        s.position = std::abs(s.time_s - peakAt_s) < sampleTime_s / 2 ? 9.0 : 1.0;
        samples.push_back(s);
    }
    return samples;
}

std::size_t points(const std::vector<LiveHistory::Stretch>& stretches)
{
    std::size_t count = 0;
    for (const LiveHistory::Stretch& stretch : stretches)
        count += stretch.size();
    return count;
}

} // namespace

class LiveHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void startsEmpty();
    void drawingCostsWhatTheWidthCosts_data();
    void drawingCostsWhatTheWidthCosts();
    void onePeakSampleIsNeverLost_data();
    void onePeakSampleIsNeverLost();
    void reachesUpToTheNewestSample();
    void valuesStandAtTheirTimes();
    void theMeanIsOfAllSamplesOfAColumn_data();
    void theMeanIsOfAllSamplesOfAColumn();
    void gapsStayGaps();
    void lostSamplesAndClockStepsAreMarked();
    void keepsTenMinutesAndForgetsWhatIsOlder();
    void aDeviceThatStartsAgainStartsANewHistory();
    void columnsStandStillWhileTheTimeMovesOn();
    void theNewestMinuteIsKeptSampleBySample();
    void aPartOfWhatIsOlderCanBeLookedAt();
    void theCommandedForceStandsWhereItIsKnown_data();
    void theCommandedForceStandsWhereItIsKnown();
    void aReadingIsOfTheNearestSample();
};

void LiveHistoryTest::startsEmpty()
{
    const LiveHistory history;
    QVERIFY(history.empty());
    QVERIFY(history.columns(LiveHistory::Channel::Force, 0, 10, 500).empty());
}

void LiveHistoryTest::drawingCostsWhatTheWidthCosts_data()
{
    QTest::addColumn<double>("seconds");
    for (const double seconds : {2.0, 10.0, 60.0, 600.0})
        QTest::newRow(qPrintable(QString::number(seconds))) << seconds;
}

void LiveHistoryTest::drawingCostsWhatTheWidthCosts()
{
    QFETCH(double, seconds);
    LiveHistory history;
    history.append(ramp(0, 620));
    const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), seconds, 800);
    QCOMPARE(stretches.size(), std::size_t{1});
    // Two points a column, one column more at either edge.
    QVERIFY(points(stretches) <= 2 * 802);
    QVERIFY(points(stretches) >= 800);
    QVERIFY(stretches.front().front().x <= -seconds + seconds / 400);
}

void LiveHistoryTest::onePeakSampleIsNeverLost_data()
{
    drawingCostsWhatTheWidthCosts_data();
}

void LiveHistoryTest::onePeakSampleIsNeverLost()
{
    QFETCH(double, seconds);
    LiveHistory history;
    const double peakAt_s = 619.2345;
    history.append(ramp(0, 620, peakAt_s));
    const double now = history.newestTime_s();
    const auto stretches = history.columns(LiveHistory::Channel::Position, now, seconds, 700);
    QCOMPARE(stretches.size(), std::size_t{1});
    const auto top = std::max_element(stretches.front().begin(), stretches.front().end(),
                                      [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; });
    QCOMPARE(top->y, 9.0);
    QVERIFY(std::abs(top->x - (peakAt_s - now)) <= seconds / 700 + 0.3 * seconds / 700);
}

void LiveHistoryTest::reachesUpToTheNewestSample()
{
    LiveHistory history;
    // 1 sample short of a round number of bins on every level.
    history.append(ramp(0, 100 * 0.128 - sampleTime_s));
    const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 600, 4000);
    QVERIFY(!stretches.empty());
    QVERIFY(stretches.back().back().x > -600.0 / 4000);
}

void LiveHistoryTest::valuesStandAtTheirTimes()
{
    LiveHistory history;
    history.append(ramp(0, 30));
    const double now = history.newestTime_s();
    for (const LiveHistory::Stretch& stretch : history.columns(LiveHistory::Channel::Force, now, 10, 1000))
        for (const PlotPoint& p : stretch)
            // A column is 10 ms wide and the sine's slope at most 1.
            QVERIFY(std::abs(p.y - std::sin(now + p.x)) <= 0.01);
}

void LiveHistoryTest::theMeanIsOfAllSamplesOfAColumn_data()
{
    drawingCostsWhatTheWidthCosts_data();
}

void LiveHistoryTest::theMeanIsOfAllSamplesOfAColumn()
{
    QFETCH(double, seconds);
    LiveHistory history;
    history.append(ramp(0, 620));
    const double now = history.newestTime_s();
    const double column_s = seconds / 800;
    // Of a sine over a width w it is sin(w/2)/(w/2) times the value in the middle: w²/24 less at most. A
    // column is made of four bins at least, so that one more or less changes w by a quarter.
    const double less = 1.6 * column_s * column_s / 24 + 1e-5;
    for (const LiveHistory::Stretch& stretch :
         history.columns(LiveHistory::Channel::Force, now, seconds, 800))
        for (const LiveHistory::Point& p : stretch)
            QVERIFY2(std::abs(p.mean - std::sin(now + p.x)) <= less, qPrintable(QString::number(p.x)));
    // One sample among many counts as one.
    history.reset(sampleTime_s);
    history.append(ramp(0, 620, 619.5));
    double sum = 0, columns = 0;
    for (const LiveHistory::Stretch& stretch :
         history.columns(LiveHistory::Channel::Position, history.newestTime_s(), seconds, 800))
        for (const LiveHistory::Point& p : stretch)
            if (p.y == 9) {
                sum += p.mean;
                ++columns;
            }
    QCOMPARE(columns, 1.0);
    // 8 above the rest, in a column of a quarter more or less samples than it is wide.
    const double samples = std::max(1.0, column_s / sampleTime_s);
    QVERIFY2(8 / (sum - 1) >= 0.7 * samples - 1 && 8 / (sum - 1) <= 1.3 * samples + 1,
             qPrintable(QString::number(sum)));
}

void LiveHistoryTest::gapsStayGaps()
{
    LiveHistory history;
    history.append(ramp(0, 5));
    history.append(ramp(6, 8));
    const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 10, 500);
    QCOMPARE(stretches.size(), std::size_t{2});
    const double hole = stretches[1].front().x - stretches[0].back().x;
    QVERIFY(std::abs(hole - 1.0) < 0.03); // to a column (20 ms)
}

void LiveHistoryTest::lostSamplesAndClockStepsAreMarked()
{
    LiveHistory history;
    history.append(ramp(0, 1));
    QVERIFY(history.gaps(1, 10).empty());
    history.append(ramp(1.001, 2)); // two samples are missing
    std::vector<Sample> stepped = ramp(2, 3);
    stepped.front().clockStepped = true;
    history.append(stepped);
    const std::vector<LiveHistory::Gap> gaps = history.gaps(3, 10);
    QCOMPARE(gaps.size(), std::size_t(2));
    QVERIFY(std::abs(gaps[0].begin + 2.0005) < 1e-9 && std::abs(gaps[0].end + 1.999) < 1e-9);
    QVERIFY(std::abs(gaps[1].end + 1) < 1e-9);
    QCOMPARE(history.gaps(3, 1.5).size(), std::size_t(1));
}

void LiveHistoryTest::keepsTenMinutesAndForgetsWhatIsOlder()
{
    LiveHistory history;
    history.append(ramp(0, 1500));
    const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 600, 600);
    QCOMPARE(stretches.size(), std::size_t{1});
    QVERIFY(stretches.front().front().x <= -598);
    const auto longer = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 1500, 600);
    QVERIFY(longer.front().front().x >
            -1100); // 8192 bins of 256 samples: 1,049 s, and no more memory than that
}

void LiveHistoryTest::aDeviceThatStartsAgainStartsANewHistory()
{
    LiveHistory history;
    history.append(ramp(0, 20));
    history.append(ramp(0, 1));
    QVERIFY(history.newestTime_s() < 1.0);
    const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 10, 500);
    QVERIFY(stretches.front().front().x >= -1.0);
}

void LiveHistoryTest::columnsStandStillWhileTheTimeMovesOn()
{
    LiveHistory history;
    history.append(ramp(0, 30));
    const double now = history.newestTime_s();
    const auto before = history.columns(LiveHistory::Channel::Force, now - 0.2, 10, 500).front();
    const auto after = history.columns(LiveHistory::Channel::Force, now - 0.193, 10, 500).front();
    // The same columns with the same numbers, only further left; the newest column may still be filling.
    const std::size_t offset = 10;
    for (std::size_t i = offset; i + 10 < before.size(); ++i) {
        const auto same = std::find_if(after.begin(), after.end(), [&](const PlotPoint& p) {
            return std::abs(p.x - (before[i].x - 0.007)) < 1e-9 && p.y == before[i].y;
        });
        QVERIFY(same != after.end());
    }
}

void LiveHistoryTest::theNewestMinuteIsKeptSampleBySample()
{
    LiveHistory history;
    history.append(ramp(0, 100));
    QVERIFY(std::abs(history.oldestFullRateTime_s() - 40) < 0.002);
    const std::vector<Sample> kept = history.samples(40.1, 99);
    QCOMPARE(kept.size(), std::size_t(117801)); // both ends
    for (std::size_t i = 0; i < kept.size(); ++i)
        QCOMPARE(kept[i].sequence, kept.front().sequence + i);
    QVERIFY(history.samples(10, 39).empty());
    QCOMPARE(history.sampleAt(50.0002)->sequence, std::uint64_t(100000));
    QVERIFY(!history.sampleAt(30));
}

void LiveHistoryTest::aPartOfWhatIsOlderCanBeLookedAt()
{
    LiveHistory history;
    const double peakAt_s = 20.5;
    history.append(ramp(0, 620, peakAt_s));
    QVERIFY(history.oldestTime_s() <= 20.5);
    const auto stretches = history.columns(LiveHistory::Channel::Position, 21, 1, 700);
    QCOMPARE(stretches.size(), std::size_t{1});
    const auto top = std::max_element(stretches.front().begin(), stretches.front().end(),
                                      [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; });
    QCOMPARE(top->y, 9.0);
    QVERIFY(std::abs(top->x + 0.5) < 0.07); // the shortest bins that reach back 600 s are of 64 ms
}

void LiveHistoryTest::theCommandedForceStandsWhereItIsKnown_data()
{
    drawingCostsWhatTheWidthCosts_data();
}

void LiveHistoryTest::theCommandedForceStandsWhereItIsKnown()
{
    QFETCH(double, seconds);
    LiveHistory history;
    const std::vector<Sample> samples = ramp(0, 610);
    std::vector<std::optional<double>> commanded(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples[i].time_s >= 608.5 && samples[i].time_s < 609.5)
            commanded[i] = 25;
    history.append(samples, commanded);
    const double now = history.newestTime_s();
    const auto found = history.columns(LiveHistory::Channel::CommandedForce, now, seconds, 800);
    QCOMPARE(found.size(), std::size_t{1});
    const double column_s = seconds / 800;
    QVERIFY(std::abs(found[0].front().x - (608.5 - now)) <= 1.3 * column_s);
    QVERIFY(std::abs(found[0].back().x - (609.5 - now)) <= 1.3 * column_s);
    for (const PlotPoint& p : found[0])
        QCOMPARE(p.y, 25.0);
    QVERIFY(!history.reading(LiveHistory::Channel::CommandedForce, 608.4));
    QCOMPARE(history.reading(LiveHistory::Channel::CommandedForce, 609)->middle(), 25.0);
}

void LiveHistoryTest::aReadingIsOfTheNearestSample()
{
    LiveHistory history;
    history.append(ramp(0, 30, 20));
    QCOMPARE(history.reading(LiveHistory::Channel::Position, 20.0002)->middle(), 9.0);
    QCOMPARE(history.reading(LiveHistory::Channel::Position, 20.0003)->middle(), 1.0);
    QVERIFY(!history.reading(LiveHistory::Channel::Force, 30.1));
    QVERIFY(!LiveHistory().reading(LiveHistory::Channel::Force, 0));
}

GRIPSCOPE_TEST(LiveHistoryTest)
#include "live_history_test.moc"
