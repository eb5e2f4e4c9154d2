// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/lag/lag_estimation.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A calibration squeeze: can A at 2 kHz in SI, bits of 5 ms, wn T = 0.25.
Synthetic calibrationSqueeze(double lag_s, double fitPercent, std::uint64_t seed = 1)
{
    Synthetic record;
    record.truth = {0.0396, 43, 9990};
    record.sampleTime_s = 0.0005;
    record.bit_s = 0.005;
    record.samples = 500;
    record.peak = 10;
    record.bias = 20;
    record.lag_s = lag_s;
    record.fitPercent = fitPercent;
    record.seed = seed;
    return record;
}

LagEstimate lagEstimate(const Recording& recording, double expectedLag_s = 0, bool holdIsKnown = true)
{
    LagEstimationOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = recording.hold.value_or(ForceHold::First);
    options.holdIsKnown = holdIsKnown;
    options.expectedLag_s = expectedLag_s;
    return estimateLag(recording.force, recording.position, options);
}

} // namespace

class LagEstimationTest : public QObject {
    Q_OBJECT
private slots:
    // Without noise the sum of squares is a parabola down to rounding; the search stops at half the digits.
    void withoutNoiseTheLagIsExact_data()
    {
        QTest::addColumn<int>("hold");
        QTest::addColumn<double>("lag");
        for (const ForceHold hold : {ForceHold::Zero, ForceHold::First}) {
            for (const double lag : {-6e-4, -1e-4, 0.0, 1e-4, 2.5e-4, 5e-4, 9.3e-4})
                QTest::addRow("%s, %g", qPrintable(toString(hold)), lag) << int(hold) << lag;
        }
    }
    void withoutNoiseTheLagIsExact()
    {
        QFETCH(int, hold);
        QFETCH(double, lag);
        Synthetic record = calibrationSqueeze(lag, 100);
        record.hold = static_cast<ForceHold>(hold);
        const LagEstimate found = lagEstimate(record.make());
        QVERIFY2(found.status == LagStatus::Measured, qPrintable(found.message.describe()));
        QVERIFY2(std::abs(found.lag_s - lag) < 1e-4 * record.sampleTime_s,
                 qPrintable(found.message.describe()));
        QVERIFY(found.standardError_s < 1e-3 * record.sampleTime_s);
    }
    // 60 squeezes: 95 % intervals cover at least 51 of them with a probability of 0.9998 (binomial), and the
    // errors' root mean square over the stated ones scatters by 9 %.
    void theStandardErrorIsTrue()
    {
        constexpr int runs = 60;
        int covered = 0;
        double squares = 0;
        for (int run = 0; run < runs; ++run) {
            const double lag_s = 3e-4 * std::sin(run);
            const LagEstimate found =
                lagEstimate(calibrationSqueeze(lag_s, 90, static_cast<std::uint64_t>(run + 1)).make());
            QVERIFY2(found.hasValue(), qPrintable(found.message.describe()));
            const double error = (found.lag_s - lag_s) / found.standardError_s;
            covered += std::abs(error) < 1.96 ? 1 : 0;
            squares += error * error / runs;
        }
        QVERIFY2(covered >= 51, qPrintable(QString::number(covered)));
        QVERIFY2(std::abs(std::sqrt(squares) - 1) < 0.3, qPrintable(QString::number(std::sqrt(squares))));
    }
    void severalSqueezesAreBetterThanOne()
    {
        std::vector<LagEstimate> squeezes;
        for (std::uint64_t seed = 1; seed <= 9; ++seed)
            squeezes.push_back(lagEstimate(calibrationSqueeze(1e-4, 90, seed).make()));
        const LagEstimate combined = combineLags(squeezes);
        QCOMPARE(combined.squeezes, 9);
        // Nine equal squeezes: a third of the error, more where they scatter by chance.
        QVERIFY(combined.standardError_s < 0.6 * squeezes.front().standardError_s);
        QVERIFY(std::abs(combined.lag_s - 1e-4) < 4 * combined.standardError_s);
        QVERIFY(combined.expectedGain > squeezes.front().expectedGain);
    }
    void scatterBetweenSqueezesMakesTheErrorLarger()
    {
        const auto squeeze = [](double lag_s, LagStatus status = LagStatus::Measured) {
            LagEstimate one;
            one.status = status;
            one.lag_s = lag_s;
            one.standardError_s = 1e-6;
            one.sampleTime_s = 5e-4;
            return one;
        };
        const std::vector<LagEstimate> squeezes{squeeze(1e-4), squeeze(2e-4), squeeze(3e-4),
                                                squeeze(9, LagStatus::AtLimit)};
        const LagEstimate combined = combineLags(squeezes);
        QCOMPARE(combined.squeezes, 3);
        QVERIFY(std::abs(combined.lag_s - 2e-4) < 1e-9);
        // The scatter of three: 1e-4 / sqrt(3).
        QVERIFY(std::abs(combined.standardError_s / (1e-4 / std::sqrt(3.0)) - 1) < 0.01);
        QVERIFY(combineLags({}).status == LagStatus::NotEstimated);
    }
    void aNoisySlowRecordIsSaidToBeTooUncertain()
    {
        Synthetic record;
        record.samples = 200;
        record.fitPercent = 70;
        const LagEstimate found = lagEstimate(record.make());
        QVERIFY2(found.status == LagStatus::TooUncertain, qPrintable(found.message.describe()));
        QVERIFY(found.expectedGain < 10);
    }
    void anUnknownHoldIsNotTakenForALag()
    {
        Synthetic slow;
        slow.samples = 200;
        slow.fitPercent = 85;
        const LagEstimate found = lagEstimate(slow.make(), 0, false);
        QVERIFY(found.holdGain.has_value());
        QVERIFY2(found.status == LagStatus::HoldOrLag, qPrintable(found.message.describe()));
        // Where the record is quiet enough, the right hold shows by itself.
        const LagEstimate told = lagEstimate(calibrationSqueeze(1e-4, 99.5).make(), 0, false);
        QVERIFY2(told.status == LagStatus::Measured, qPrintable(told.message.describe()));
        QVERIFY(*told.holdGain > 10);
    }
    void aLagOutsideTheRangeIsSaidToBe()
    {
        const Recording recording = calibrationSqueeze(4.1e-3, 99).make();
        QVERIFY(lagEstimate(recording).status == LagStatus::AtLimit);
        const LagEstimate found = lagEstimate(recording, 4e-3);
        QVERIFY2(found.status == LagStatus::Measured, qPrintable(found.message.describe()));
        QVERIFY(std::abs(found.lag_s - 4.1e-3) < 5 * found.standardError_s);
    }
    void lostSamplesAreLeftOut()
    {
        Recording recording = calibrationSqueeze(2e-4, 97).make();
        LagEstimationOptions options;
        options.sampleTime_s = recording.sampleTime_s;
        options.hold = ForceHold::Zero;
        options.lost = {40, 41, 42, 200, 333};
        for (const std::size_t index : options.lost)
            recording.force[index] = recording.position[index] = 1e3;
        const LagEstimate found = estimateLag(recording.force, recording.position, options);
        QVERIFY2(found.hasValue(), qPrintable(found.message.describe()));
        QVERIFY(std::abs(found.lag_s - 2e-4) < 5 * found.standardError_s);
    }
    void nonsenseGivesWords()
    {
        const Recording recording = calibrationSqueeze(0, 95).make();
        LagEstimationOptions options;
        QVERIFY(estimateLag(recording.force, recording.position, options).status == LagStatus::NotEstimated);
        options.sampleTime_s = 0.0005;
        QVERIFY(estimateLag({}, {}, options).status == LagStatus::NotEstimated);
        QVERIFY(estimateLag({1, 2, 3}, {1, 2, 3}, options).status == LagStatus::NotEstimated);
        QVERIFY(estimateLag({1, 2, 3}, {1, 2}, options).status == LagStatus::NotEstimated);
        const std::vector<double> constant(100, 1.0);
        QVERIFY(!estimateLag(constant, constant, options).hasValue());
        options.expectedLag_s = 1e300;
        QVERIFY(!estimateLag(recording.force, recording.position, options).hasValue());
        options.expectedLag_s = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!estimateLag(recording.force, recording.position, options).message.isEmpty());
    }
};

GRIPSCOPE_TEST(LagEstimationTest)
#include "lag_estimation_test.moc"
