// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/device_link.h"
#include "devices/acquisition/stream_watch.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <functional>
#include <random>

using namespace gripscope;
using namespace std::chrono_literals;

namespace {

constexpr double begin_s = 5000;

std::int64_t nanoseconds(double seconds)
{
    return static_cast<std::int64_t>(std::llround(1e9 * seconds));
}

/// How much later than sent a report is read at a moment, in seconds.
using Lateness = std::function<double(double)>;

/// A program that does not run for whole stretches reads what waits at their end, all at once.
Lateness heldUp(const std::vector<std::pair<double, double>>& stretches)
{
    return [stretches](double now_s) {
        for (const auto& [from_s, to_s] : stretches)
            if (now_s >= from_s && now_s < to_s)
                return to_s - now_s;
        return 0.0;
    };
}

/// Held up again and again: `busy` of the time, for `typical_s` on average.
Lateness busy(double share, double typical_s, unsigned seed)
{
    std::mt19937 engine(seed);
    std::exponential_distribution<double> length_s(1 / typical_s);
    std::vector<std::pair<double, double>> stretches;
    for (double at_s = 0; at_s < 100;) {
        const double idle_s = length_s(engine) * (1 - share) / share, held_s = length_s(engine);
        stretches.emplace_back(at_s + idle_s, at_s + idle_s + held_s);
        at_s += idle_s + held_s;
    }
    return heldUp(stretches);
}

/// What is known after `seconds` of a clock that is `drift_ppm` fast; `each` looks at it after each report.
std::optional<RateDifference>
compared(double drift_ppm, double seconds, const Lateness& lateness, double period_s = 0.001,
         const std::function<void(double, const std::optional<RateDifference>&)>& each = {})
{
    ClockComparison clocks;
    std::mt19937 engine(7);
    std::exponential_distribution<double> late_s(1 / 0.0003);
    double read_s = 0; // in order, whatever held them up
    for (double true_s = 0; true_s < seconds; true_s += period_s) {
        // A host polls a millisecond's frames.
        const double polled_s = 0.001 * std::ceil(true_s / 0.001) + late_s(engine);
        read_s = std::max(read_s, polled_s + lateness(polled_s));
        clocks.take(nanoseconds(begin_s + read_s), true_s * (1 + 1e-6 * drift_ppm), period_s);
        if (each)
            each(true_s, clocks.difference());
    }
    return clocks.difference();
}

} // namespace

class ClockComparisonTest : public QObject {
    Q_OBJECT
private slots:
    void tellsTheDriftThroughLateArrivals_data()
    {
        QTest::addColumn<double>("drift_ppm");
        QTest::newRow("the same") << 0.0;
        QTest::newRow("fast") << 200.0;
        QTest::newRow("slow") << -3000.0;
        QTest::newRow("twice as fast") << 1e6;
    }
    void tellsTheDriftThroughLateArrivals()
    {
        QFETCH(double, drift_ppm);
        bool young = true;
        const auto found = compared(drift_ppm, 20, heldUp({}), 0.001,
                                    [&](double at_s, const std::optional<RateDifference>& known) {
                                        young = young && (at_s > 0.9 || !known);
                                    });
        QVERIFY(young);
        QVERIFY(found);
        QVERIFY2(std::abs(found->ppm - drift_ppm) < 60, qPrintable(QString::number(found->ppm)));
        QVERIFY2(found->uncertainty_ppm < 800, qPrintable(QString::number(found->uncertainty_ppm)));
    }

    void aBusyComputerRaisesNoFalseAlarm_data()
    {
        QTest::addColumn<int>("pattern");
        QTest::newRow("often for a moment") << 0;
        QTest::newRow("half of the time") << 1;
        QTest::newRow("nearly always, long") << 2;
        QTest::newRow("until a moment") << 3;
        QTest::newRow("from a moment on") << 4;
        QTest::newRow("slow reports") << 5;
    }
    void aBusyComputerRaisesNoFalseAlarm()
    {
        QFETCH(int, pattern);
        // 60 ppm are a good crystal's; the truth is never outside of what is claimed, at no moment.
        constexpr double truth_ppm = 60;
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const double moment_s = 0.7 * seed;
            std::vector<std::pair<double, double>> queue;
            const Lateness late =
                pattern == 0   ? busy(0.2, 0.02, seed)
                : pattern == 1 ? busy(0.5, 0.08, seed)
                : pattern == 2 ? busy(0.9, 0.15, seed)
                : pattern == 3 ? Lateness([moment_s](double now_s) {
                      return now_s < moment_s ? 0.015 : 0.0; // a queue that is never empty
                  })
                : pattern == 4
                    ? Lateness([moment_s](double now_s) { return now_s >= moment_s ? 0.015 : 0.0; })
                    : busy(0.5, 0.08, seed);
            double worst = 0;
            compared(truth_ppm, 16, late, pattern == 5 ? 0.02 : 0.001,
                     [&](double, const std::optional<RateDifference>& known) {
                         if (known)
                             worst =
                                 std::max(worst, std::abs(known->ppm - truth_ppm) - known->uncertainty_ppm);
                     });
            QVERIFY2(worst <= 0, qPrintable(QStringLiteral("seed %1: %2 ppm").arg(seed).arg(worst)));
        }
    }

    void aWrongClockIsCertainInSeconds_data()
    {
        QTest::addColumn<double>("drift_ppm");
        QTest::addColumn<double>("limit_ppm");
        QTest::addColumn<double>("within_s");
        QTest::newRow("0.5 %") << 5000.0 << 1000.0 << 3.0;
        QTest::newRow("0.5 % slow") << -5000.0 << 1000.0 << 3.0;
        QTest::newRow("1.5 %") << 15000.0 << 10000.0 << 3.0;
        QTest::newRow("1.5 % slow") << -15000.0 << 10000.0 << 3.0;
        QTest::newRow("5.5 %") << 55000.0 << 10000.0 << 1.5;
        QTest::newRow("10 % slow") << -100000.0 << 10000.0 << 1.5;
        QTest::newRow("0.16 %") << 1600.0 << 1000.0 << 32.0;
    }
    void aWrongClockIsCertainInSeconds()
    {
        QFETCH(double, drift_ppm);
        QFETCH(double, limit_ppm);
        QFETCH(double, within_s);
        const auto known = compared(drift_ppm, within_s, heldUp({}));
        QVERIFY(known && known->beyond(limit_ppm));
        // A busy computer only takes longer to be certain.
        const auto later = compared(drift_ppm, 3 * within_s, busy(0.3, 0.03, 5));
        QVERIFY(later && (later->beyond(limit_ppm) || within_s > 10));
    }

    void aConnectionOfHoursIsJudgedByItsLastHalfMinute()
    {
        ClockComparison clocks;
        for (int i = 0; i < 90000; ++i) // fast by 2 % for a minute, right for half a minute
            clocks.take(1'000'000LL * i, 0.001 * i + 0.02 * 0.001 * std::min(i, 60000), 0.001);
        QVERIFY(clocks.difference() && std::abs(clocks.difference()->ppm) < 1000);
    }

    void aClockThatWasSetBeginsAnew()
    {
        ClockComparison clocks;
        for (int i = 0; i < 2000; ++i)
            clocks.take(1'000'000LL * i, 0.001 * i, 0.001);
        QVERIFY(clocks.difference());
        clocks.restart();
        QVERIFY(!clocks.difference());
    }

    void ratesAreThoseOfTheLastSecond()
    {
        RateMeter meter;
        const RateMeter::TimePoint begin(100s);
        for (int ms = 0; ms <= 3000; ms += 16)
            meter.take(begin + std::chrono::milliseconds(ms), std::uint64_t(ms), std::uint64_t(2 * ms));
        QVERIFY(std::abs(meter.reportRate_Hz() - 1000) < 1);
        QVERIFY(std::abs(meter.sampleRate_Hz() - 2000) < 2);
        for (int ms = 3016; ms <= 4500; ms += 16) // nothing more comes
            meter.take(begin + std::chrono::milliseconds(ms), 3000, 6000);
        QCOMPARE(meter.reportRate_Hz(), 0.0);
    }
};

GRIPSCOPE_TEST(ClockComparisonTest)
#include "clock_comparison_test.moc"
