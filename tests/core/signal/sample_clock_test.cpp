// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/signal/preparation/sample_clock.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

constexpr double nominal_s = 0.0005;

struct Stamps {
    std::vector<double> time_s;
    std::vector<std::uint64_t> sequence;
};

/// Samples of a clock that runs at (1 + drift) nominal, each off by jitter sample times, a share lost.
Stamps stamps(std::size_t count, double drift, double jitter, double lossShare, std::uint64_t seed = 1)
{
    GaussianNoise random(seed);
    Stamps result;
    for (std::size_t n = 0; n < count; ++n) {
        const double off = jitter * random();
        const bool lost = n > 0 && random.uniform() < lossShare;
        if (lost)
            continue;
        result.time_s.push_back(3 + nominal_s * (1 + drift) * (static_cast<double>(n) + off));
        result.sequence.push_back(1000 + n);
    }
    return result;
}

std::vector<std::int64_t> trueIndex(const Stamps& made)
{
    std::vector<std::int64_t> index;
    for (const std::uint64_t number : made.sequence)
        index.push_back(static_cast<std::int64_t>(number - made.sequence.front()));
    return index;
}

} // namespace

class SampleClockTest : public QObject {
    Q_OBJECT
private slots:
    void aRegularClockIsLeftAlone_data()
    {
        QTest::addColumn<double>("resolution");
        QTest::newRow("exact") << 0.0;
        QTest::newRow("printed") << 1e-9;
        QTest::newRow("microseconds") << 1e-6;
        QTest::newRow("coarse stamps") << 1e-4; // a fifth of a sample time
    }
    void aRegularClockIsLeftAlone()
    {
        QFETCH(double, resolution);
        std::vector<double> time_s;
        for (int n = 0; n < 2000; ++n) {
            const double t = 1.0 / 3 + n * (nominal_s * 1.0000001);
            time_s.push_back(resolution > 0 ? resolution * std::round(t / resolution) : t);
        }
        const SampleClock clock = readSampleClock(time_s, {}, nominal_s);
        QVERIFY(!clock.drifts);
        QVERIFY(!clock.jittered);
        QCOMPARE(clock.sampleTime_s, nominal_s);
        QCOMPARE(clock.lost, std::int64_t(0));
        QCOMPARE(clock.index.back(), std::int64_t(1999));
    }
    // The truth lies within five standard errors (one in 1.7 million outside).
    void aDriftIsMeasured()
    {
        for (const double jitter : {0.0, 0.1}) {
            const Stamps made = stamps(1000, 2e-3, jitter, 0.05);
            const SampleClock clock = readSampleClock(made.time_s, made.sequence, nominal_s);
            QVERIFY(clock.drifts);
            QVERIFY(std::abs(clock.drift - 2e-3) <= 5 * clock.driftError + 1e-12);
            QVERIFY(clock.driftError < 2e-5);
            QVERIFY(std::abs(clock.sampleTime_s / nominal_s - 1 - clock.drift) < 1e-12);
        }
    }
    void jitterAloneIsNoDrift()
    {
        int drifting = 0;
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Stamps made = stamps(300, 0, 0.1, 0, seed);
            const SampleClock clock = readSampleClock(made.time_s, {}, nominal_s);
            QVERIFY(clock.jittered);
            // The root mean square of 300 scatters by 4 %.
            QVERIFY(std::abs(clock.jitter - 0.1) < 0.02);
            drifting += clock.drifts ? 1 : 0;
        }
        QCOMPARE(drifting, 0);
    }
    void aLateSampleIsNoLoss()
    {
        // Half a sample time is five deviations of this jitter: it happens some times in a million.
        Stamps made = stamps(20000, 0, 0.1, 0);
        for (const std::size_t i : {5u, 3000u, 19990u})
            made.time_s[i] += 0.45 * nominal_s;
        const SampleClock clock = readSampleClock(made.time_s, {}, nominal_s);
        QCOMPARE(clock.lost, std::int64_t(0));
        QCOMPARE(clock.gaps, std::size_t(0));
        QVERIFY(clock.index == trueIndex(made));
    }
    void lostSamplesAreFoundWithAndWithoutNumbers_data()
    {
        QTest::addColumn<double>("drift");
        QTest::addColumn<double>("jitter");
        QTest::addColumn<double>("loss");
        for (const double loss : {0.01, 0.2, 0.6}) {
            QTest::addRow("%g lost", loss) << 0.0 << 0.0 << loss;
            QTest::addRow("%g lost, jitter and drift", loss) << 0.003 << 0.08 << loss;
        }
    }
    void lostSamplesAreFoundWithAndWithoutNumbers()
    {
        QFETCH(double, drift);
        QFETCH(double, jitter);
        QFETCH(double, loss);
        const Stamps made = stamps(3000, drift, jitter, loss);
        const std::vector<std::int64_t> index = trueIndex(made);
        QVERIFY(readSampleClock(made.time_s, {}, nominal_s).index == index);
        const SampleClock clock = readSampleClock(made.time_s, made.sequence, nominal_s);
        QVERIFY(clock.index == index);
        QCOMPARE(clock.lost, index.back() + 1 - static_cast<std::int64_t>(index.size()));
        QCOMPARE(clock.breaks, std::size_t(0));
    }
    void aClockThatWasSetIsABreakAndNotAGap()
    {
        Stamps made = stamps(200, 0, 0, 0);
        for (std::size_t i = 120; i < 200; ++i)
            made.time_s[i] += 7.3 * nominal_s;
        const SampleClock clock = readSampleClock(made.time_s, made.sequence, nominal_s);
        QCOMPARE(clock.breaks, std::size_t(1));
        QVERIFY(!clock.drifts);
        QVERIFY(!clock.jittered);
        QVERIFY(clock.index[120] - clock.index[119] > 1000); // nothing bridges it
        QCOMPARE(clock.lost, std::int64_t(0));
    }
    void timeOrNumbersThatRunBackwardsAreBreaks()
    {
        Stamps made = stamps(200, 0, 0, 0);
        for (std::size_t i = 120; i < 200; ++i)
            made.sequence[i] -= 1100;
        QCOMPARE(readSampleClock(made.time_s, made.sequence, nominal_s).breaks, std::size_t(1));
        for (std::size_t i = 60; i < 200; ++i)
            made.time_s[i] -= 1;
        const SampleClock clock = readSampleClock(made.time_s, {}, nominal_s);
        QCOMPARE(clock.breaks, std::size_t(1));
        for (std::size_t i = 1; i < clock.index.size(); ++i)
            QVERIFY(clock.index[i] > clock.index[i - 1]);
    }
    void theRateIsKnownOnBothSidesOfABreak()
    {
        Stamps made = stamps(400, 1e-3, 0.1, 0);
        const double before = readSampleClock(made.time_s, made.sequence, nominal_s).driftError;
        for (std::size_t i = 200; i < 400; ++i)
            made.time_s[i] += 1;
        const SampleClock clock = readSampleClock(made.time_s, made.sequence, nominal_s);
        // Two halves of the length have a quarter of the whole's squares: twice the error.
        QVERIFY(clock.driftError > 1.8 * before && clock.driftError < 2.2 * before);
        QVERIFY(std::abs(clock.drift - 1e-3) < 5 * clock.driftError);
        QVERIFY(std::abs(clock.jitter - 0.1) < 0.02);
    }
    void aLongGapDoesNotSpoilTheRate()
    {
        Stamps made = stamps(400, 1e-3, 0, 0);
        for (std::size_t i = 200; i < 400; ++i)
            made.time_s[i] += 1e5;
        const SampleClock clock = readSampleClock(made.time_s, {}, nominal_s);
        QVERIFY(std::abs(clock.drift - 1e-3) < 1e-9);
        QVERIFY(!clock.jittered);
        QVERIFY(clock.lost > 100'000'000);
    }
    void anyTimesGiveAnIndexThatIncreases()
    {
        const std::vector<std::vector<double>> cases{
            {}, {1}, {1, 2}, {0, 1e300}, {-1e308, 1e308, 1.1e308}, {5, 5, 5}, {0, 1e-300, 1}, {3, 2, 1, 0}};
        for (const std::vector<double>& time_s : cases) {
            const SampleClock clock = readSampleClock(time_s, {}, 0.01);
            QCOMPARE(clock.index.size(), time_s.size());
            QVERIFY(std::isfinite(clock.sampleTime_s) && clock.sampleTime_s > 0);
            for (std::size_t i = 1; i < time_s.size(); ++i) {
                QVERIFY(clock.index[i] > clock.index[i - 1]);
                QVERIFY(std::isfinite(clock.time[i]));
            }
        }
    }
};

GRIPSCOPE_TEST(SampleClockTest)
#include "sample_clock_test.moc"
