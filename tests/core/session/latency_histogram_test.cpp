// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/latency_histogram.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace std::chrono_literals;

class LatencyHistogramTest : public QObject {
    Q_OBJECT
private slots:
    void quantilesAreThoseOfWhatWasAdded()
    {
        LatencyHistogram histogram;
        const LatencyHistogram::TimePoint now(100s);
        QCOMPARE(histogram.quantile_ms(0.5, now), 0.0);
        for (int i = 0; i < 1000; ++i)
            histogram.add(0.02 * i, now);
        histogram.add(300, now, 5);
        QVERIFY(std::abs(histogram.quantile_ms(0.5, now) - 10) <= 0.25);
        QVERIFY(std::abs(histogram.quantile_ms(0.99, now) - 19.9) <= 0.25);
        QVERIFY(histogram.quantile_ms(1, now) >= 300 && histogram.quantile_ms(1, now) <= 300 * 1.125);
    }

    void whatIsOlderThanTenSecondsIsForgotten()
    {
        LatencyHistogram histogram;
        histogram.add(500, LatencyHistogram::TimePoint(100s));
        for (int second = 101; second < 110; ++second)
            histogram.add(1, LatencyHistogram::TimePoint(std::chrono::seconds(second)));
        QVERIFY(histogram.quantile_ms(1, LatencyHistogram::TimePoint(109s)) >= 500);
        QCOMPARE(histogram.quantile_ms(1, LatencyHistogram::TimePoint(110s)), 1.25);
        QCOMPARE(histogram.quantile_ms(1, LatencyHistogram::TimePoint(300s)), 0.0);
    }

    void valuesOfAnySizeHaveAPlace()
    {
        LatencyHistogram histogram;
        const LatencyHistogram::TimePoint now(1s);
        for (const double ms : {-5.0, 0.0, 63.999, 64.0, 1e4, 1e300, double(NAN), double(INFINITY)})
            histogram.add(ms, now);
        QVERIFY(histogram.quantile_ms(1, now) >= 1e4);
    }
};

GRIPSCOPE_TEST(LatencyHistogramTest)
#include "latency_histogram_test.moc"
