// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/clock_comparison.h"
#include "devices/acquisition/rate_meter.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <random>

using namespace gripscope;
using namespace std::chrono_literals;

class ClockComparisonTest : public QObject {
    Q_OBJECT
private slots:
    void tellsTheDriftThroughLateArrivals_data()
    {
        QTest::addColumn<double>("drift_ppm");
        QTest::newRow("the same") << 0.0;
        QTest::newRow("fast") << 200.0;
        QTest::newRow("slow") << -3000.0;
    }
    void tellsTheDriftThroughLateArrivals()
    {
        QFETCH(double, drift_ppm);
        ClockComparison clocks;
        std::mt19937 engine(3);
        std::exponential_distribution<double> late_s(1 / 0.002);
        constexpr double begin_s = 5000;
        for (int i = 0; i < 5000; ++i) {
            const double true_s = 0.001 * i;
            const double arrival_s = begin_s + true_s + 0.0005 + late_s(engine);
            clocks.take(static_cast<std::int64_t>(1e9 * arrival_s), true_s * (1 + 1e-6 * drift_ppm));
            QVERIFY(i > 900 || !clocks.drift_ppm());
        }
        QVERIFY2(std::abs(*clocks.drift_ppm() - drift_ppm) < 30,
                 qPrintable(QString::number(*clocks.drift_ppm())));
    }

    void aClockThatWasSetBeginsAnew()
    {
        ClockComparison clocks;
        for (int i = 0; i < 2000; ++i)
            clocks.take(1'000'000LL * i, 0.001 * i);
        QVERIFY(clocks.drift_ppm());
        clocks.restart();
        QVERIFY(!clocks.drift_ppm());
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
