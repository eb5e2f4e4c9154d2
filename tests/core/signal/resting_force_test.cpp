// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/signal/preparation/preparation.h"
#include "core/signal/preparation/preparation_parts.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// White noise of standard deviation 0.02 about a zero that drifts by as much.
std::vector<double> noisyRest(std::size_t samples)
{
    GaussianNoise noise(3);
    std::vector<double> force(samples);
    for (std::size_t i = 0; i < samples; ++i)
        force[i] = 0.02 * static_cast<double>(i) / static_cast<double>(samples) + 0.02 * noise();
    return force;
}

/// Force at rest before the device says that it moves.
Recording withRestBefore(std::size_t rest)
{
    Recording recording;
    recording.sampleTime_s = 0.001;
    recording.force = noisyRest(rest);
    for (std::size_t i = 0; i < 300; ++i)
        recording.force.push_back(i / 20 % 2 == 0 ? 10.0 : 20.0);
    for (std::size_t i = 0; i < recording.force.size(); ++i) {
        recording.time_s.push_back(static_cast<double>(i) * recording.sampleTime_s);
        recording.position.push_back(recording.force[i] * 1e-4);
        recording.status.push_back(i < rest ? 0 : StatusMoving);
    }
    return recording;
}

} // namespace

class RestingForceTest : public QObject {
    Q_OBJECT
private slots:
    void whiteNoiseIsMeasuredInSpiteOfADrift()
    {
        // Four standard errors of 0.02 sqrt(3 / (4 N)).
        const double found = restingForceNoise(noisyRest(2000)).value();
        QVERIFY2(std::abs(found - 0.02) < 4 * 0.02 * std::sqrt(3.0 / 8000),
                 qPrintable(QString::number(found)));
    }
    void aStillMovingOrShortForceTellsNothing()
    {
        QVERIFY(!restingForceNoise(std::vector<double>(100, 1.0)));
        QVERIFY(!restingForceNoise(noisyRest(leastRestingSamples - 1)));
        std::vector<double> stepped(100, 0.0); // a converter that changes its step now and then
        for (std::size_t i = 0; i < stepped.size(); i += 10)
            stepped[i] = 0.01;
        QVERIFY(!restingForceNoise(stepped));
        std::vector<double> ramp = noisyRest(100); // the gripper closes on the object
        for (std::size_t i = 0; i < ramp.size(); ++i)
            ramp[i] += 0.02 * static_cast<double>(i);
        QVERIFY(!restingForceNoise(ramp));
        QVERIFY(!restingForceNoise(std::vector<double>(100, 1e308)));
        std::vector<double> huge(100, 1e308);
        for (std::size_t i = 0; i < huge.size(); i += 2)
            huge[i] = -1e308;
        QVERIFY(!restingForceNoise(huge)); // no infinity comes out
    }
    void whatCameBeforeTheSqueezeTellsTheForcesNoise()
    {
        const PreparedRecord prepared = prepare(withRestBefore(200));
        const PreparationStep* step = prepared.find(u"force_noise"_s);
        QVERIFY(step != nullptr);
        QCOMPARE(step->count, std::size_t(200));
        QCOMPARE(prepared.chain.forceNoiseDeviation, step->value);
        QVERIFY(std::abs(step->value - 0.02) < 4 * 0.02 * std::sqrt(3.0 / 800));
    }
    void whatIsStatedIsNotMeasured()
    {
        Recording recording = withRestBefore(200);
        recording.chain.forceNoiseDeviation = 0.5;
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(prepared.chain.forceNoiseDeviation, 0.5);
        QVERIFY(prepared.find(u"force_noise"_s) == nullptr);
    }
    void aSqueezeWithoutRestBeforeItLeavesTheNoiseUnknown()
    {
        QCOMPARE(prepare(withRestBefore(0)).chain.forceNoiseDeviation, 0.0);
        QCOMPARE(prepare(withRestBefore(10)).chain.forceNoiseDeviation, 0.0);
    }
};

GRIPSCOPE_TEST(RestingForceTest)
#include "resting_force_test.moc"
