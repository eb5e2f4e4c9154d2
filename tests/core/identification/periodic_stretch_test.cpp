// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic/periodic_search.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;

namespace {

std::vector<double> periodicForce(ExcitationKind kind, std::size_t samples, std::size_t periods, double noise,
                                  double drift)
{
    ExcitationOptions options;
    options.kind = kind;
    options.peak = 1;
    options.bias = 3;
    options.bit_s = 0.5;
    options.sampleTime_s = 0.05;
    options.samples = samples;
    options.periods = periods;
    std::vector<double> force = *makeExcitation(options);
    GaussianNoise random(7);
    double walk = 0;
    for (double& f : force) {
        walk += drift * random();
        f += walk + noise * random();
    }
    return force;
}

} // namespace

class PeriodicStretchTest : public QObject {
    Q_OBJECT
private slots:
    void thePeriodIsFoundUnderNoiseAndDrift_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("samples");
        QTest::addColumn<int>("periods");
        QTest::addColumn<double>("noise");
        QTest::addColumn<double>("drift"); ///< standard deviation of a step of a random walk
        QTest::addColumn<int>("period");
        const int binary = static_cast<int>(ExcitationKind::InverseRepeat);
        const int sines = static_cast<int>(ExcitationKind::Multisine);
        QTest::newRow("binary") << binary << 1240 << 8 << 0.0 << 0.0 << 140;
        QTest::newRow("binary, noise") << binary << 1240 << 4 << 0.2 << 0.0 << 300;
        QTest::newRow("binary, drift") << binary << 2500 << 4 << 0.05 << 0.005 << 620;
        QTest::newRow("sines") << sines << 2000 << 8 << 0.0 << 0.0 << 250;
        // The peak of a smooth force is flat: the far periods tell where it is.
        QTest::newRow("sines, noise") << sines << 2000 << 8 << 0.1 << 0.0 << 250;
        QTest::newRow("sines, a part of a period more") << sines << 2013 << 5 << 0.02 << 0.001 << 402;
        QTest::newRow("many periods") << binary << 20000 << 100 << 0.3 << 0.0 << 140;
    }
    void thePeriodIsFoundUnderNoiseAndDrift()
    {
        QFETCH(int, kind);
        QFETCH(int, samples);
        QFETCH(int, periods);
        QFETCH(double, noise);
        QFETCH(double, drift);
        QFETCH(int, period);
        const std::vector<double> force =
            periodicForce(static_cast<ExcitationKind>(kind), static_cast<std::size_t>(samples),
                          static_cast<std::size_t>(periods), noise, drift);
        const std::optional<std::size_t> found = findPeriod(force);
        QVERIFY(found);
        QCOMPARE(*found, static_cast<std::size_t>(period));
        const Window stretch = periodicStretch(force, *found);
        QVERIFY(stretch == (Window{0, force.size()}));
    }

    void whatDoesNotRepeatHasNoPeriod_data()
    {
        QTest::addColumn<QVector<double>>("force");
        QVector<double> noise, step, ramp;
        GaussianNoise random(3);
        for (int i = 0; i < 500; ++i) {
            noise.push_back(random());
            step.push_back(i < 250 ? 0 : 1);
            ramp.push_back(i);
        }
        QTest::newRow("noise") << noise;
        QTest::newRow("a step") << step;
        QTest::newRow("a ramp") << ramp;
        QTest::newRow("constant") << QVector<double>(500, 3.0);
        QTest::newRow("nothing") << QVector<double>();
        QTest::newRow("three samples") << QVector<double>{1, 2, 1};
        QTest::newRow("huge") << QVector<double>{1e300, -1e300, 3e299,  1e300, 1e300, 2, 7e299, 0, 1,
                                                 1,     1,      -1e300, 0,     1e300, 5, 6,     7};
    }
    void whatDoesNotRepeatHasNoPeriod()
    {
        QFETCH(QVector<double>, force);
        QVERIFY(!findPeriod(std::span<const double>(force.data(), static_cast<std::size_t>(force.size()))));
    }
    void aBinarySequenceThatRunsOnceHasNoPeriod()
    {
        ExcitationOptions options;
        options.samples = 1000;
        options.bit_s = 5 * options.sampleTime_s;
        QVERIFY(!findPeriod(*makeExcitation(options)));
    }

    void touchAndReleaseAreLeftOut()
    {
        // Nothing, then five periods on a preload, then release.
        std::vector<double> force(60, 0.0);
        const std::vector<double> squeeze = periodicForce(ExcitationKind::InverseRepeat, 1500, 5, 0.05, 0);
        force.insert(force.end(), squeeze.begin(), squeeze.end());
        force.insert(force.end(), 45, 0.0);
        const std::optional<std::size_t> period = findPeriod(force);
        QVERIFY(period);
        QCOMPARE(*period, std::size_t(300));
        const Window stretch = periodicStretch(force, *period);
        // A few samples at either end differ by less than what the noise does over a period.
        QVERIFY(stretch.first >= 55 && stretch.first <= 62);
        QVERIFY(stretch.first + stretch.count >= 1555 && stretch.first + stretch.count <= 1565);
    }
    void aWrongPeriodHasNoStretch()
    {
        const std::vector<double> force = periodicForce(ExcitationKind::InverseRepeat, 1500, 5, 0.05, 0);
        QCOMPARE(periodicStretch(force, 211).count, std::size_t(0));
        QCOMPARE(periodicStretch(force, 1400).count, std::size_t(0));
        QCOMPARE(periodicStretch({}, 10).count, std::size_t(0));
    }
};

GRIPSCOPE_TEST(PeriodicStretchTest)
#include "periodic_stretch_test.moc"
