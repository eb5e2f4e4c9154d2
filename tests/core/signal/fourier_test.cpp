// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/fourier.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;

namespace {

std::vector<double> noise(std::size_t count)
{
    GaussianNoise random(count + 1);
    std::vector<double> values(count);
    for (double& value : values)
        value = random();
    return values;
}

} // namespace

class FourierTest : public QObject {
    Q_OBJECT
private slots:
    void theTransformIsTheSumItStandsFor_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {1, 2, 3, 4, 8, 31, 64, 127, 620, 1000})
            QTest::addRow("%d", count) << count;
    }
    void theTransformIsTheSumItStandsFor()
    {
        QFETCH(int, count);
        const std::vector<double> values = noise(static_cast<std::size_t>(count));
        const std::vector<std::complex<double>> bins = fourierTransform(values);
        QCOMPARE(bins.size(), values.size() / 2 + 1);
        for (std::size_t q = 0; q < bins.size(); ++q) {
            std::complex<double> sum = 0;
            for (std::size_t t = 0; t < values.size(); ++t)
                sum += values[t] *
                       std::polar(1.0, -2 * std::numbers::pi * double(q * t % values.size()) / count);
            // Rounding of values of about 1, times the logarithm of the count.
            QVERIFY(std::abs(bins[q] - sum / std::sqrt(double(count))) < 1e-12);
        }
    }
    void autocorrelationIsTheSumItStandsFor()
    {
        const std::vector<double> values = noise(100);
        const std::vector<double> lags = autocorrelation(values, 250);
        QCOMPARE(lags.size(), values.size());
        for (std::size_t lag = 0; lag < lags.size(); ++lag) {
            double sum = 0;
            for (std::size_t t = 0; t + lag < values.size(); ++t)
                sum += values[t] * values[t + lag];
            QVERIFY(std::abs(lags[lag] - sum) < 1e-11);
        }
    }
    void nothingGivesNothing()
    {
        QVERIFY(fourierTransform({}).empty());
        QVERIFY(autocorrelation({}, 5).empty());
    }
};

GRIPSCOPE_TEST(FourierTest)
#include "fourier_test.moc"
