// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/correlation.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace gripscope;

namespace {

/// White and uniform: 53 bits of the generator, the same everywhere.
std::vector<double> whiteSeries(std::size_t count, std::uint64_t seed)
{
    std::mt19937_64 generator(seed);
    std::vector<double> values(count);
    for (double& value : values)
        value = static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5;
    return values;
}

double at(const Correlation& correlation, int lag)
{
    for (std::size_t i = 0; i < correlation.lags.size(); ++i)
        if (correlation.lags[i] == lag)
            return correlation.values[i];
    return NAN;
}

} // namespace

class CorrelationTest : public QObject {
    Q_OBJECT
private slots:
    void shortSeriesByHand()
    {
        // e = 1, -1, 2, -2: mean 0, squares 10; lag 1: -1 - 2 - 4 = -7; lag 2: 2 + 2 = 4; lag 3: -2.
        const Correlation r = autocorrelation(std::vector<double>{1, -1, 2, -2}, 10);
        QCOMPARE(r.values.size(), std::size_t(4));
        QCOMPARE(r.values[0], 1.0);
        QVERIFY(std::abs(r.values[1] + 0.7) < 1e-15);
        QVERIFY(std::abs(r.values[2] - 0.4) < 1e-15);
        QVERIFY(std::abs(r.values[3] + 0.2) < 1e-15);
        QVERIFY(std::abs(r.band - 0.98) < 1e-4);
    }
    void whiteNoiseKeepsToTheBand()
    {
        const Correlation r = autocorrelation(whiteSeries(2000, 1), 200);
        int outside = 0;
        for (std::size_t k = 1; k < r.values.size(); ++k)
            outside += std::abs(r.values[k]) > r.band ? 1 : 0;
        // 5 % of 200 are 10, with a binomial standard deviation of 3.1: within four of them.
        QVERIFY(outside <= 22);
    }
    void aDelayedInputShowsAtItsLag()
    {
        const std::vector<double> u = whiteSeries(1000, 2);
        std::vector<double> e(u.size(), 0.0);
        for (std::size_t t = 7; t < e.size(); ++t)
            e[t] = 3 * u[t - 7];
        const Correlation r = crossCorrelation(e, u, 20);
        QCOMPARE(r.lags.front(), -20);
        QCOMPARE(r.lags.back(), 20);
        QVERIFY(at(r, 7) > 0.98);
        QVERIFY(std::abs(at(r, -7)) < 0.2);
        const Correlation back = crossCorrelation(u, e, 20);
        QVERIFY(at(back, -7) > 0.98);
    }
    void scaleDoesNotMatter()
    {
        const std::vector<double> e = whiteSeries(300, 3);
        for (const double scale : {1e-170, 1e170}) {
            std::vector<double> scaled = e;
            for (double& value : scaled)
                value *= scale;
            const Correlation a = autocorrelation(e, 5);
            const Correlation b = autocorrelation(scaled, 5);
            for (int lag = 0; lag <= 5; ++lag)
                QVERIFY(std::abs(at(a, lag) - at(b, lag)) < 1e-9);
        }
    }
    void withoutVariationThereAreNoValues()
    {
        QVERIFY(autocorrelation(std::vector<double>{}, 5).values.empty());
        QVERIFY(autocorrelation(std::vector<double>(10, 4.0), 5).values.empty());
        QVERIFY(crossCorrelation(std::vector<double>{1, 2, 3}, std::vector<double>{1, 2}, 1).values.empty());
    }
};

GRIPSCOPE_TEST(CorrelationTest)
#include "correlation_test.moc"
