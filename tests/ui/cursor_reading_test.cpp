// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/format/cursor_reading.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace Qt::StringLiterals;
using namespace gripscope;

/// What cursors read from the live charts.
class CursorReadingTest : public QObject {
    Q_OBJECT

    static constexpr double sampleTime_s = 0.0005;
    static constexpr double stiffness = 10000; ///< N/m
    static constexpr double forceNoise_N = 0.02, positionNoise_m = 5e-6;

    /// A slow push from 0 to `seconds` N against a spring, with the noise of the virtual gripper.
    static LiveHistory push(double seconds)
    {
        std::mt19937_64 random(3);
        std::normal_distribution<double> noise;
        LiveHistory history(600, sampleTime_s);
        std::vector<Sample> samples;
        for (int i = 0; i < static_cast<int>(seconds / sampleTime_s); ++i) {
            Sample s;
            s.sequence = static_cast<std::uint64_t>(i);
            s.time_s = i * sampleTime_s;
            s.force = s.time_s + forceNoise_N * noise(random);
            s.position = s.time_s / stiffness + positionNoise_m * noise(random);
            samples.push_back(s);
        }
        history.append(samples);
        return history;
    }

private slots:
    void aSampleIsReadWithTheNoiseAroundIt()
    {
        const LiveHistory history = push(20);
        const CursorReading reading = readCursor(history, 10);
        QVERIFY(reading.force && reading.position);
        QVERIFY(!reading.force->range);
        QVERIFY(std::abs(reading.force->value - 10) < 5 * forceNoise_N);
        // The median of 198 third differences is good to some 8 %; three times that.
        QVERIFY(std::abs(reading.force->halfWidth / (1.96 * forceNoise_N) - 1) < 0.25);
        QVERIFY(std::abs(reading.position->halfWidth / (1.96 * positionNoise_m) - 1) < 0.25);
    }
    void whatIsOlderIsARange()
    {
        const LiveHistory history = push(100);
        const CursorReading reading = readCursor(history, 5);
        QVERIFY(reading.force && reading.force->range);
        QVERIFY(reading.force->halfWidth > 0);
        QVERIFY(std::abs(reading.force->value - 5) <= reading.force->halfWidth + 0.1);
    }
    void nothingIsReadBeforeTheBeginningAndInAGap()
    {
        LiveHistory history = push(2);
        Sample late;
        late.sequence = 10000;
        late.time_s = 5;
        history.append({late});
        QVERIFY(!readCursor(history, -1).force);
        QVERIFY(!readCursor(history, 3.5).force);
        QVERIFY(!readCursor(history, 6).force);
        QVERIFY(readCursor(history, 5).force);
    }
    void theSlopeIsTheStiffnessWithinItsInterval()
    {
        const LiveHistory history = push(20);
        int inside = 0;
        for (int i = 0; i < 100; ++i) {
            const auto slope =
                slopeBetween(readCursor(history, 2 + 0.01 * i), readCursor(history, 12 + 0.01 * i));
            QVERIFY(slope);
            inside += std::abs(slope->value - stiffness) <= slope->halfWidth ? 1 : 0;
        }
        // 95 of 100 on average; 87 are 3.7 standard deviations less.
        QVERIFY2(inside >= 87, qPrintable(QString::number(inside)));
    }
    void whereThePositionDoesNotChangeThereIsNone()
    {
        const LiveHistory history = push(20);
        QVERIFY(!slopeBetween(readCursor(history, 10), readCursor(history, 10)));
        QVERIFY(!slopeBetween({}, readCursor(history, 10)));
    }
    void unitsOfTheSlopeAreHonest_data()
    {
        QTest::addColumn<QString>("force");
        QTest::addColumn<QString>("position");
        QTest::addColumn<QString>("text");
        QTest::newRow("SI") << u"N"_s << u"m"_s << u"12.5 ± 0.2\u00A0N/m"_s;
        QTest::newRow("millimetres") << u"N"_s << u"mm"_s << u"12.5 ± 0.2\u00A0kN/m"_s;
        QTest::newRow("as printed") << u"1"_s << u"1"_s << u"12.5 ± 0.2"_s;
        QTest::newRow("not known") << u"V"_s << u"mm"_s << u"12.5 ± 0.2\u00A0V/mm"_s;
    }
    void unitsOfTheSlopeAreHonest()
    {
        QFETCH(QString, force);
        QFETCH(QString, position);
        QTEST(slopeText({12.5, 0.2, false}, force, position).text(), "text");
    }
};

GRIPSCOPE_TEST(CursorReadingTest)
#include "cursor_reading_test.moc"
