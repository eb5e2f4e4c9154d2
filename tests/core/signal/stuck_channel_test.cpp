// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/signal/preparation/sensor_faults.h"
#include "tests/core/signal/measured_can.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using test::Synthetic;

namespace {

Recording squeeze(double noise_m, double count_m)
{
    test::MeasuredCan can;
    can.forceNoise_N = can.forceCount_N = 0;
    can.positionNoise_m = noise_m;
    can.positionCount_m = count_m;
    return can.make();
}

void hold(std::vector<double>& values, std::size_t first, std::size_t count)
{
    std::fill_n(values.begin() + std::ptrdiff_t(first), count, values[first]);
}

} // namespace

class StuckChannelTest : public QObject {
    Q_OBJECT
private slots:
    void aChannelThatStopsIsFound_data()
    {
        QTest::addColumn<double>("noise_m");
        QTest::addColumn<double>("count_m");
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("count");
        QTest::newRow("all the time") << 5e-6 << 20e-6 << 0 << 2000;
        QTest::newRow("from the fifth sample on") << 5e-6 << 20e-6 << 5 << 1995;
        QTest::newRow("from the middle on") << 5e-6 << 20e-6 << 1000 << 1000;
        QTest::newRow("for a while") << 5e-6 << 20e-6 << 700 << 700;
        QTest::newRow("no noise") << 0.0 << 1e-6 << 500 << 1000;
        QTest::newRow("no counts") << 5e-6 << 0.0 << 500 << 100;
    }
    void aChannelThatStopsIsFound()
    {
        QFETCH(double, noise_m);
        QFETCH(double, count_m);
        QFETCH(int, first);
        QFETCH(int, count);
        Recording recording = squeeze(noise_m, count_m);
        hold(recording.position, std::size_t(first), std::size_t(count));
        const std::optional<Window> found = stuckStretch(recording.position, recording.force);
        QVERIFY(found);
        // The neighbours may have the same value.
        QVERIFY(found->first <= std::size_t(first) && found->first + 100 > std::size_t(first));
        QVERIFY(found->count >= std::size_t(count) && found->count < std::size_t(count) + 100);
    }
    void whatMayStandStillIsNotAccused()
    {
        // A settled position under a step, two levels of a force that is commanded, a slow object on coarse
        // steps, a rest.
        Synthetic step;
        step.kind = ExcitationKind::Step;
        const Recording settled = step.make();
        QVERIFY(!stuckStretch(settled.position, settled.force));
        const Recording binary = squeeze(0, 0);
        QVERIFY(!stuckStretch(binary.force, binary.position));
        for (const double count_m : {20e-6, 100e-6, 500e-6, 900e-6}) {
            const Recording coarse = squeeze(0, count_m);
            QVERIFY2(!stuckStretch(coarse.position, coarse.force), qPrintable(QString::number(count_m)));
        }
        Recording rest = squeeze(0, 0);
        GaussianNoise noise(3);
        for (double& force : rest.force)
            force = 0.02 * noise();
        rest.position.assign(rest.size(), 0.0123);
        QVERIFY(!stuckStretch(rest.position, rest.force));
        QVERIFY(!stuckStretch({}, {}));
    }
    void aForceThatStopsIsFound()
    {
        Recording recording = test::MeasuredCan().make();
        hold(recording.force, 800, 1200);
        const std::optional<Window> found = stuckStretch(recording.force, recording.position);
        QVERIFY(found && found->first == 800 && found->count == 1200);
    }
    void goodSqueezesAreNeverAccused()
    {
        int runs = 0;
        test::forGoodSqueezes(500, [&runs](const Recording& good, const QString& words) {
            ++runs;
            QVERIFY2(!stuckStretch(good.position, good.force), qPrintable(words));
        });
        QCOMPARE(runs, 500);
    }
};

GRIPSCOPE_TEST(StuckChannelTest)
#include "stuck_channel_test.moc"
