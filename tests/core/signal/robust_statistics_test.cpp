// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/math/robust_statistics.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace gripscope;

namespace {

std::vector<double> slowSignal(std::size_t count, double noise)
{
    GaussianNoise random(3);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = std::sin(0.1 * static_cast<double>(i)) + noise * random();
    return values;
}

} // namespace

class RobustStatisticsTest : public QObject {
    Q_OBJECT
private slots:
    void quantilesAreOrderStatistics()
    {
        const std::vector<double> values{5, 1, 4, 2, 3};
        QCOMPARE(quantile(values, 0), 1.0);
        QCOMPARE(quantile(values, 0.5), 3.0);
        QCOMPARE(quantile(values, 1), 5.0);
        QCOMPARE(quantile(values, 7), 5.0);
        QCOMPARE(quantile({}, 0.5), 0.0);
    }
    // The median of N correlated absolute differences scatters by some 2.5 / sqrt(N): 6 % at N = 2000.
    void theNoiseOfASlowSignalIsFoundAtAnyScale()
    {
        for (const double scale : {1e-300, 1.0, 1e300}) {
            std::vector<double> values = slowSignal(2000, 0.05);
            for (double& value : values)
                value *= scale;
            QVERIFY(std::abs(whiteNoiseDeviation(values) / (0.05 * scale) - 1) < 0.15);
        }
    }
    void jumpsAreNoNoise()
    {
        std::vector<double> values = slowSignal(2000, 0.05);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] += i / 40 % 2 == 0 ? 10 : -10;
        QVERIFY(std::abs(whiteNoiseDeviation(values) / 0.05 - 1) < 0.25);
    }
    void withoutNoiseThereIsNone()
    {
        QVERIFY(whiteNoiseDeviation(slowSignal(500, 0)) < 1e-3);
        QCOMPARE(whiteNoiseDeviation(std::vector<double>(100, 7.0)), 0.0);
        QCOMPARE(whiteNoiseDeviation(std::vector<double>{1, 2, 3}), 0.0);
    }
};

GRIPSCOPE_TEST(RobustStatisticsTest)
#include "robust_statistics_test.moc"
