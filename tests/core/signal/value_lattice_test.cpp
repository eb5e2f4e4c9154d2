// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/math/value_lattice.h"
#include "core/signal/preparation/sensor_faults.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace gripscope;

namespace {

std::vector<double> noisySine(std::size_t count, double amplitude, double noise)
{
    GaussianNoise random(11);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = amplitude * std::sin(0.05 * static_cast<double>(i)) + noise * random();
    return values;
}

std::vector<double> rounded(std::vector<double> values, double step, double shift = 0)
{
    for (double& value : values)
        value = step * std::round(value / step) + shift;
    return values;
}

} // namespace

class ValueLatticeTest : public QObject {
    Q_OBJECT
private slots:
    void theStepIsFound_data()
    {
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("shift");
        QTest::newRow("coarse") << 0.125 << 0.0;
        QTest::newRow("decimal") << 0.001 << 0.0;
        QTest::newRow("not a decimal") << 0.0123456789 << 0.0;
        QTest::newRow("off zero") << 0.01 << 0.00377;
        QTest::newRow("on a large offset") << 0.01 << 1234.5;
    }
    void theStepIsFound()
    {
        QFETCH(double, step);
        QFETCH(double, shift);
        for (const double scale : {1e-9, 1.0, 1e9}) {
            std::vector<double> values = rounded(noisySine(1000, 1, 0.05), step, shift);
            for (double& value : values)
                value *= scale;
            const std::optional<double> found = latticeStep(values);
            QVERIFY(found.has_value());
            // As good as the values' own rounding, 1e-9 of the largest, lets it be.
            QVERIFY(std::abs(*found / (step * scale) - 1) < 1e-6);
        }
    }
    void aLatticeWithoutNeighboursIsFoundToo()
    {
        // Differences of 4, 6 and 10: none of them is the step, 2.
        const auto found = latticeStep(std::vector<double>{0, 4, 10, 20, 26, 30, 40, 46, 50, 60});
        QVERIFY(found && std::abs(*found - 2) < 1e-12);
    }
    void whatHasNoLatticeHasNone()
    {
        QVERIFY(!latticeStep(noisySine(1000, 1, 0.05)));
        QVERIFY(!latticeStep(noisySine(1000, 1e-300, 0)));
        QVERIFY(!latticeStep({}));
        QVERIFY(!latticeStep(std::vector<double>(50, 3.0)));
        std::vector<double> huge = noisySine(100, 1e308, 0);
        huge[0] = -1.7e308;
        huge[1] = 1.7e308;
        QVERIFY(!latticeStep(huge));
    }
    void twoLevelsAreNoLattice()
    {
        std::vector<double> values;
        for (int i = 0; i < 100; ++i)
            values.push_back(i / 10 % 2 == 0 ? 10 : 30);
        QVERIFY(!latticeStep(values));
    }
    void samplesHeldAtARailAreCounted()
    {
        std::vector<double> values = noisySine(1000, 1, 0.01);
        std::size_t above = 0, below = 0;
        for (double& value : values) {
            above += value > 0.8 ? 1 : 0;
            below += value < -0.9 ? 1 : 0;
            value = std::clamp(value, -0.9, 0.8);
        }
        const ClippedSamples clipped = clippedSamples(values);
        // Runs of one and two at the edges, where the noise plays around the rail, do not count.
        QVERIFY(clipped.atHighest <= above && clipped.atHighest > 9 * above / 10);
        QVERIFY(clipped.atLowest <= below && clipped.atLowest > 9 * below / 10);
    }
    void levelsByDesignAreNoRails()
    {
        std::vector<double> binary, settling, oneSided = noisySine(1000, 1, 0);
        double position = 0;
        for (int i = 0; i < 1000; ++i) {
            binary.push_back(i / 50 % 2 == 0 ? 10 : 30);
            position += 0.6 * (binary.back() - position); // stands still to the last bit before the next jump
            settling.push_back(position);
        }
        for (double& value : oneSided)
            value = std::max(value, 0.0);
        QCOMPARE(clippedSamples(binary).total(), std::size_t(0));
        QCOMPARE(clippedSamples(settling).total(), std::size_t(0));
        QCOMPARE(clippedSamples(oneSided).total(), std::size_t(0));
        QCOMPARE(clippedSamples(noisySine(1000, 1, 0.1)).total(), std::size_t(0));
        QCOMPARE(clippedSamples({}).total(), std::size_t(0));
    }
    /// Levels of force that a part reaches within a sample, its position in coarse counts.
    void whatSettlesWithinASampleIsNotClipped()
    {
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 1);
        std::vector<double> force, position;
        double level = 30;
        for (int i = 0; i < 100; ++i) {
            position.push_back(std::round((level + 0.01 * noise(random)) / 0.2) * 0.2 +
                               (i % 17 == 0 ? -0.2 : 0));
            if (i % 4 == 0)
                level = random() % 2 == 0 ? 10 : 30;
            force.push_back(level + 0.02 * noise(random));
        }
        QVERIFY(clippedSamples(position, 0.2).total() > 10); // by its look alone
        QCOMPARE(clippedSamples(position, 0.2, force).total(), std::size_t(0));
        // Under a force that goes on moving the same is a rail.
        for (std::size_t i = 0; i < force.size(); ++i)
            force[i] += 8 * std::sin(0.9 * double(i));
        QVERIFY(clippedSamples(position, 0.2, force).total() > 10);
    }
    /// A part that takes ten samples to move, its position cut off: also where a level lasts longer.
    void whatIsCutOffOnItsWayIsClippedUnderAConstantForceToo()
    {
        std::vector<double> force, position;
        std::size_t above = 0;
        double x = 10;
        for (int i = 0; i < 2000; ++i) {
            position.push_back(std::min(std::round(x / 0.02) * 0.02, 22.0));
            above += x > 22 ? 1 : 0;
            force.push_back(i / 40 % 2 == 0 ? 30 : 10);
            x += 0.1 * (force.back() - x);
        }
        const ClippedSamples clipped = clippedSamples(position, 0.02, force);
        QVERIFY(clipped.atHighest > 9 * above / 10);
        QCOMPARE(clipped.atLowest, std::size_t(0));
    }
    void aSlowQuantisedSignalIsNotClipped()
    {
        const std::vector<double> values = rounded(noisySine(3000, 1, 0), 0.05);
        QCOMPARE(clippedSamples(values, 0.05).total(), std::size_t(0));
    }
};

GRIPSCOPE_TEST(ValueLatticeTest)
#include "value_lattice_test.moc"
