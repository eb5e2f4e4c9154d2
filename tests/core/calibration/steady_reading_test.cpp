// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_plan.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace gripscope;

namespace {

std::vector<double> channel(GaussianNoise& noise, double drift, double pole = 0)
{
    std::vector<double> values;
    double colored = 0;
    for (int i = 0; i < 2000; ++i) {
        colored = pole * colored + std::sqrt(1 - pole * pole) * noise();
        values.push_back(30 + drift * i / 2000 + 0.02 * colored);
    }
    return values;
}

} // namespace

class SteadyReadingTest : public QObject {
    Q_OBJECT
private slots:
    void whatRestsIsSteady_data()
    {
        QTest::addColumn<double>("pole");
        QTest::newRow("white noise") << 0.0;
        QTest::newRow("coloured noise") << 0.9;
    }
    void whatRestsIsSteady()
    {
        QFETCH(double, pole);
        GaussianNoise noise(3);
        int alarms = 0;
        for (int run = 0; run < 500; ++run)
            alarms += steadyReading(channel(noise, 0, pole), {}).status == SteadyStatus::Moving ? 1 : 0;
        QVERIFY2(alarms <= 4, qPrintable(QString::number(alarms))); // 0.5 expected; more than 4 once in 5,000
    }
    void whatCreepsIsMoving()
    {
        GaussianNoise noise(4);
        for (int run = 0; run < 100; ++run) {
            const SteadyReading reading = steadyReading(channel(noise, 0.05), {});
            QVERIFY(reading.status == SteadyStatus::Moving);
            QVERIFY(std::abs(reading.drift - 0.05) < 0.01); // its standard error is 0.0015
        }
    }
    void aDriftOfNoAccountIsLetPass()
    {
        GaussianNoise noise(5);
        SteadyOptions options;
        options.driftAllowed = 0.1;
        QVERIFY(steadyReading(channel(noise, 0.05), options).status == SteadyStatus::Steady);
    }
    void meanAndDeviationAreThoseOfTheSamples()
    {
        GaussianNoise noise(6);
        const SteadyReading reading = steadyReading(channel(noise, 0), {});
        QVERIFY(std::abs(reading.mean - 30) < 5 * 0.02 / std::sqrt(2000.0));
        QVERIFY(std::abs(reading.deviation / 0.02 - 1) < 5 / std::sqrt(4000.0));
        QCOMPARE(reading.samples, std::size_t(2000));
    }
    void aConstantIsSteady()
    {
        const std::vector<double> values(100, 1e9);
        const SteadyReading reading = steadyReading(values, {});
        QVERIFY(reading.status == SteadyStatus::Steady);
        QCOMPARE(reading.mean, 1e9);
        QCOMPARE(reading.deviation, 0.0);
    }
    void tooLittleIsSaid()
    {
        QVERIFY(steadyReading(std::vector<double>(19, 1.0), {}).status == SteadyStatus::TooFewSamples);
        QVERIFY(steadyReading({}, {}).status == SteadyStatus::TooFewSamples);
    }
};

GRIPSCOPE_TEST(SteadyReadingTest)
#include "steady_reading_test.moc"
