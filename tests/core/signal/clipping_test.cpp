// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/sensor_faults.h"
#include "tests/core/signal/measured_can.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>

using namespace gripscope;
using test::MeasuredCan;

namespace {

/// The value that the share `share` of a channel's range lies below.
double railAt(const std::vector<double>& values, double share, double count)
{
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    const double rail = *lowest + share * (*highest - *lowest);
    return count > 0 ? count * std::round(rail / count) : rail;
}

} // namespace

class ClippingTest : public QObject {
    Q_OBJECT
private slots:
    void aChannelThatEndsAtARailIsFound_data()
    {
        QTest::addColumn<bool>("force");
        QTest::addColumn<bool>("high");
        QTest::addColumn<double>("share"); ///< of the range where the rail is
        QTest::newRow("force, high, half of it") << true << true << 0.6;
        QTest::newRow("force, high, its noise only") << true << true << 0.98;
        QTest::newRow("force, low") << true << false << 0.3;
        QTest::newRow("position, high") << false << true << 0.7;
        QTest::newRow("position, low") << false << false << 0.5;
        QTest::newRow("position, high, most of it") << false << true << 0.4;
    }
    void aChannelThatEndsAtARailIsFound()
    {
        QFETCH(bool, force);
        QFETCH(bool, high);
        QFETCH(double, share);
        MeasuredCan can;
        Recording recording = can.make();
        std::vector<double>& channel = force ? recording.force : recording.position;
        const double rail = railAt(channel, share, force ? can.forceCount_N : can.positionCount_m);
        std::size_t clipped = 0;
        for (double& value : channel) {
            clipped += (high ? value >= rail : value <= rail) ? 1 : 0;
            value = high ? std::min(value, rail) : std::max(value, rail);
        }
        const SaturatedSamples found = saturatedSamples(recording, {0, recording.size()});
        const SaturatedChannel& told = force ? found.force : found.position;
        const SaturatedChannel& other = force ? found.position : found.force;
        QCOMPARE(other.count(), std::size_t(0));
        QCOMPARE(told.marked, std::size_t(0));
        QVERIFY2(told.count() > recording.size() / 100 && told.count() <= clipped,
                 qPrintable(QStringLiteral("%1 of %2").arg(told.count()).arg(clipped)));
    }
    void theDevicesWordCountsForTheChannelItNames()
    {
        Recording recording = MeasuredCan().make();
        recording.status.assign(recording.size(), StatusMoving);
        recording.status[5] |= StatusPositionSaturated;
        recording.status[6] |= StatusForceSaturated;
        recording.status[7] |= StatusForceSaturated;
        const SaturatedSamples found = saturatedSamples(recording, {0, recording.size()});
        QCOMPARE(found.position.count(), std::size_t(1));
        QCOMPARE(found.force.count(), std::size_t(2));
        QCOMPARE(saturatedSamples(recording, {7, 100}).force.count(), std::size_t(1));
    }
    void goodSqueezesAreNeverAccused()
    {
        int runs = 0;
        test::forGoodSqueezes(500, [&runs](const Recording& good, const QString& words) {
            ++runs;
            const SaturatedSamples found = saturatedSamples(good, {0, good.size()});
            QVERIFY2(found.force.count() + found.position.count() == 0,
                     qPrintable(QStringLiteral("%1: %2 of force, %3 of position")
                                    .arg(words)
                                    .arg(found.force.count())
                                    .arg(found.position.count())));
        });
        QCOMPARE(runs, 500);
    }
};

GRIPSCOPE_TEST(ClippingTest)
#include "clipping_test.moc"
