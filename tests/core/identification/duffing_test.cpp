// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/motion_model.h"
#include "core/identification/output_error/output_error.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/core/identification/duffing_simulation.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTest>

#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::relativeDifference;
using test::Synthetic;

namespace {

/// A record of a cubic spring; `cubicShare` is k3 a^2 / k at a = 1 / k, the position under the peak force.
Recording cubicRecord(const Synthetic& synthetic, double cubicShare, double noise = 0)
{
    Recording recording = synthetic.make();
    const double k = synthetic.truth.k;
    recording.position = test::simulateDuffing(synthetic.truth, cubicShare * k * k * k, recording.force,
                                               {synthetic.sampleTime_s, synthetic.hold, synthetic.lag_s,
                                                synthetic.x0, synthetic.v0, synthetic.offset});
    GaussianNoise random(synthetic.seed + 1000000);
    for (double& y : recording.position)
        y += noise * random();
    return recording;
}

MotionOptions duffingOptions(const Recording& recording, bool free)
{
    MotionOptions options = test::duffingOptions(recording.sampleTime_s);
    options.hold = recording.hold.value_or(ForceHold::First);
    options.lag_s = recording.forceLag_s;
    options.freeInitialState = free;
    options.freeOffset = free;
    return options;
}

Estimate duffingEstimate(const Recording& recording, bool free)
{
    return estimateMotion(recording.force, recording.position, duffingOptions(recording, free));
}

QString describeDuffing(const Estimate& e)
{
    if (!e.parameters)
        return toString(e.status) + u": "_s + e.message.describe();
    return u"%1: m %2 b %3 k %4 k3 %5, %6 iterations"_s.arg(toString(e.status))
        .arg(e.parameters->m, 0, 'g', 12)
        .arg(e.parameters->b, 0, 'g', 12)
        .arg(e.parameters->k, 0, 'g', 12)
        .arg(test::cubicOf(e), 0, 'g', 12)
        .arg(e.iterations);
}

/// What the estimator's own integration makes of it.
std::vector<double> integrated(const Synthetic& synthetic, double k3, const std::vector<double>& force)
{
    MotionProblem problem;
    problem.terms.cubic = true;
    problem.force = force;
    problem.hold = synthetic.hold;
    problem.sampleTime_s = synthetic.sampleTime_s;
    problem.lag = LagAlignment(synthetic.lag_s, synthetic.sampleTime_s);
    MotionPoint point;
    MotionValues values;
    values[MotionParameter::Mass] = synthetic.truth.m;
    values[MotionParameter::Damping] = synthetic.truth.b;
    values[MotionParameter::Stiffness] = synthetic.truth.k;
    values[MotionParameter::Cubic] = k3;
    point.values = inProblemUnits(problem, values);
    point.x0 = synthetic.x0;
    point.v0 = synthetic.v0 * synthetic.sampleTime_s;
    point.offset = synthetic.offset;
    return positionsAt(problem, point);
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = a.size() == b.size() ? 0 : 1e300;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

} // namespace

class DuffingTest : public QObject {
    Q_OBJECT
private slots:
    void theMotionIsThatOfAnAdaptiveIntegrator_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("damping");
        QTest::addColumn<bool>("straight");
        for (const double share : {-0.01, 0.0, 0.5, 5.0}) {
            for (const double damping : {0.1, 1.0, 5.0}) {
                for (const bool straight : {false, true})
                    QTest::addRow("cubic share %g, damping %g, %s", share, damping, straight ? "foh" : "zoh")
                        << share << damping << straight;
            }
        }
    }
    void theMotionIsThatOfAnAdaptiveIntegrator()
    {
        QFETCH(double, share);
        QFETCH(double, damping);
        QFETCH(bool, straight);
        Synthetic synthetic;
        const double w = 6;
        synthetic.truth = {0.04, 2 * damping * w * 0.04, w * w * 0.04};
        synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
        synthetic.samples = 200;
        synthetic.x0 = 0.2;
        synthetic.v0 = -1;
        synthetic.offset = 3;
        const Recording recording = cubicRecord(synthetic, share);
        const double k = synthetic.truth.k;
        const std::vector<double> own = integrated(synthetic, share * k * k * k, recording.force);
        // 200 samples, each to 1e-12 of positions of about 1, by both.
        const double difference = largestDifference(recording.position, own);
        QVERIFY2(difference < 1e-10, qPrintable(QString::number(difference)));
    }

    void withoutACubicSpringTheMotionIsTheLinearOne_data()
    {
        QTest::addColumn<double>("lag");
        for (const double lag : {0.0, 0.4, 3.0, 2.7, -1.3})
            QTest::addRow("lag %g samples", lag) << lag;
    }
    void withoutACubicSpringTheMotionIsTheLinearOne()
    {
        QFETCH(double, lag);
        for (const ForceHold hold : {ForceHold::Zero, ForceHold::First}) {
            Synthetic synthetic;
            synthetic.hold = hold;
            synthetic.lag_s = lag * synthetic.sampleTime_s;
            synthetic.x0 = 2;
            synthetic.v0 = -3;
            synthetic.offset = 5;
            const Recording linear = synthetic.make();
            QVERIFY(largestDifference(integrated(synthetic, 0, linear.force), linear.position) < 1e-11);
        }
    }

    void withoutNoiseTheTruthComesBack_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("damping");
        QTest::addColumn<bool>("straight");
        QTest::addColumn<double>("lag");
        QTest::addColumn<bool>("moving");
        for (const double share : {-0.01, 0.3, 5.0}) {
            for (const double damping : {0.05, 1.08, 4.0}) {
                for (const double lag : {0.0, 0.4, -1.3}) {
                    QTest::addRow("cubic share %g, damping %g, lag %g, zoh, rest", share, damping, lag)
                        << share << damping << false << lag << false;
                    QTest::addRow("cubic share %g, damping %g, lag %g, foh, free", share, damping, lag)
                        << share << damping << true << lag << true;
                }
            }
        }
    }
    void withoutNoiseTheTruthComesBack()
    {
        QFETCH(double, share);
        QFETCH(double, damping);
        QFETCH(bool, straight);
        QFETCH(double, lag);
        QFETCH(bool, moving);
        Synthetic synthetic;
        const double w = 1.6;
        synthetic.truth = {0.4, 2 * damping * w * 0.4, w * w * 0.4};
        synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
        synthetic.lag_s = lag * synthetic.sampleTime_s;
        if (moving) {
            synthetic.x0 = 0.3;
            synthetic.v0 = -0.5;
            synthetic.offset = 50;
        }
        const Recording recording = cubicRecord(synthetic, share);
        const Estimate e = duffingEstimate(recording, moving);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describeDuffing(e)));
        // The integration's own error, 1e-9 of the position, times the condition of the problem (about 100).
        QVERIFY2(relativeDifference(*e.parameters, synthetic.truth) < 1e-6, qPrintable(describeDuffing(e)));
        const double k3 = share * std::pow(synthetic.truth.k, 3);
        QVERIFY2(std::abs(test::cubicOf(e) / k3 - 1) < 1e-5, qPrintable(describeDuffing(e)));
        if (moving)
            QVERIFY(std::abs(*e.nuisance.offset - 50) < 1e-6);
        QCOMPARE(e.simulated.size(), recording.size());
        QCOMPARE(e.residual.size(), recording.size());
    }

    void startsTenTimesOffFindTheSameAnswer()
    {
        Synthetic synthetic;
        synthetic.truth = {0.4, 0.3, 1};
        const Recording recording = cubicRecord(synthetic, 0.5, 0.05);
        const Estimate own = duffingEstimate(recording, true);
        QVERIFY2(own.status == EstimateStatus::Converged, qPrintable(describeDuffing(own)));
        for (const double m : {0.1, 10.0}) {
            for (const double b : {0.1, 10.0}) {
                for (const double k : {0.1, 10.0}) {
                    for (const double k3 : {-1.0, 0.05, 5.0}) {
                        MotionOptions options = duffingOptions(recording, true);
                        options.start = MassDampingStiffness{m * 0.4, b * 0.3, k * 1};
                        options.startTerms[MotionParameter::Cubic] = k3;
                        const Estimate e = estimateMotion(recording.force, recording.position, options);
                        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describeDuffing(e)));
                        QVERIFY2(relativeDifference(*e.parameters, *own.parameters) < 1e-6,
                                 qPrintable(describeDuffing(e)));
                    }
                }
            }
        }
    }

    void aLinearSpringHasNoCubicTermAndTheParametersOfOutputError()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        synthetic.samples = 1000;
        const Recording recording = synthetic.make();
        const Estimate cubic = duffingEstimate(recording, true);
        QVERIFY2(cubic.status == EstimateStatus::Converged, qPrintable(describeDuffing(cubic)));
        const double k3Error = std::sqrt(cubic.motion->covariance(3, 3));
        QVERIFY(std::abs(test::cubicOf(cubic)) < 4 * k3Error);
        OutputErrorOptions options;
        options.sampleTime_s = recording.sampleTime_s;
        options.hold = ForceHold::Zero;
        const Estimate linear = estimateOutputError(recording.force, recording.position, options);
        // One more parameter moves the others by what it adds to their variance (Hausman 1978).
        for (Eigen::Index i = 0; i < 3; ++i) {
            const double added = (*cubic.covariance)(i, i) - (*linear.covariance)(i, i);
            const double moved = cubic.parameters->vector()(i) - linear.parameters->vector()(i);
            QVERIFY2(std::abs(moved) < 4 * std::sqrt(std::abs(added)) + 1e-9,
                     qPrintable(describeDuffing(cubic)));
        }
    }

    void unitsChangeNothingButUnits_data()
    {
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("position");
        QTest::addColumn<double>("time");
        for (const double force : {1e-6, 1e6, 1e30}) {
            for (const double position : {1e-6, 1e6, 1e-30})
                QTest::addRow("force %g, position %g", force, position) << force << position << 1.0;
        }
        QTest::newRow("fast") << 1.0 << 1.0 << 1e-6;
        QTest::newRow("slow") << 1.0 << 1.0 << 1e6;
    }
    void unitsChangeNothingButUnits()
    {
        QFETCH(double, force);
        QFETCH(double, position);
        QFETCH(double, time);
        Synthetic synthetic;
        synthetic.truth = {0.4, 0.3, 1};
        synthetic.offset = 1;
        Recording recording = cubicRecord(synthetic, 0.5, 0.05);
        const Estimate e = duffingEstimate(recording, true);
        for (double& f : recording.force)
            f *= force;
        for (double& y : recording.position)
            y *= position;
        recording.sampleTime_s *= time;
        const Estimate scaled = duffingEstimate(recording, true);
        QVERIFY2(scaled.status == EstimateStatus::Converged, qPrintable(describeDuffing(scaled)));
        const double unit = force / position;
        const MassDampingStiffness back{scaled.parameters->m / unit / time / time,
                                        scaled.parameters->b / unit / time, scaled.parameters->k / unit};
        // The search ends within 1e-8 standard errors, here some percent.
        QVERIFY2(relativeDifference(back, *e.parameters) < 1e-7, qPrintable(describeDuffing(scaled)));
        const double k3 = test::cubicOf(scaled) / unit * position * position;
        QVERIFY2(std::abs(k3 / test::cubicOf(e) - 1) < 1e-6, qPrintable(describeDuffing(scaled)));
        const double error = std::sqrt(scaled.motion->covariance(3, 3)) / unit * position * position;
        QVERIFY(std::abs(error / std::sqrt(e.motion->covariance(3, 3)) - 1) < 1e-5);
    }

    void longRecordsGiveTheSameAnswerWithASmallerError()
    {
        Synthetic synthetic;
        synthetic.truth = {0.4, 0.3, 1};
        synthetic.samples = 30000;
        const Recording recording = cubicRecord(synthetic, 0.5, 0.1);
        const Estimate e = duffingEstimate(recording, true);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describeDuffing(e)));
        const Eigen::Vector3d z =
            (e.parameters->vector() - synthetic.truth.vector()).cwiseQuotient(*e.standardErrors());
        QVERIFY2(z.cwiseAbs().maxCoeff() < 4.5, qPrintable(describeDuffing(e)));
        QVERIFY(((*e.standardErrors()).cwiseQuotient(synthetic.truth.vector())).maxCoeff() < 0.01);
    }

    void whatCannotBeAnsweredSaysWhy_data()
    {
        QTest::addColumn<QList<double>>("force");
        QTest::addColumn<QList<double>>("position");
        QTest::addColumn<QString>("status");
        QList<double> ramp;
        QList<double> noise;
        GaussianNoise random(3);
        for (int i = 0; i < 60; ++i) {
            ramp << i;
            noise << random();
        }
        QTest::newRow("nothing") << QList<double>() << QList<double>() << u"too_few_samples"_s;
        QTest::newRow("three samples")
            << QList<double>{1, 2, 3} << QList<double>{1, 2, 3} << u"too_few_samples"_s;
        QTest::newRow("unequal lengths") << noise << QList<double>{1, 2} << u"not_applicable"_s;
        QTest::newRow("constant position") << noise << QList<double>(60, 2.0) << u"not_identifiable"_s;
        QTest::newRow("constant force") << QList<double>(60, 2.0) << noise << u"not_identifiable"_s;
        QTest::newRow("no force") << QList<double>(60, 0.0) << ramp << u"not_identifiable"_s;
    }
    void whatCannotBeAnsweredSaysWhy()
    {
        QFETCH(QList<double>, force);
        QFETCH(QList<double>, position);
        QFETCH(QString, status);
        const MotionOptions options = test::duffingOptions(0.01);
        const Estimate e =
            estimateMotion({force.begin(), force.end()}, {position.begin(), position.end()}, options);
        QCOMPARE(toString(e.status), status);
        QVERIFY(!e.parameters && !e.message.isEmpty());
    }

    void anyNumbersGiveFiniteAnswersOrNone()
    {
        GaussianNoise random(11);
        for (int run = 0; run < 60; ++run) {
            std::vector<double> force;
            std::vector<double> position;
            const double forceSize = std::pow(10.0, -300 + 600 * random.uniform());
            const double positionSize = std::pow(10.0, -300 + 600 * random.uniform());
            const auto samples = static_cast<std::size_t>(3 + 60 * random.uniform());
            for (std::size_t i = 0; i < samples; ++i) {
                force.push_back(forceSize * random());
                position.push_back(run % 3 == 0 ? positionSize * static_cast<double>(i % 7)
                                                : positionSize * random());
            }
            MotionOptions options = test::duffingOptions(std::pow(10.0, -6 + 12 * random.uniform()));
            options.hold = run % 2 == 0 ? ForceHold::Zero : ForceHold::First;
            options.lag_s = run % 5 == 0 ? 1.4 * options.sampleTime_s : 0;
            options.freeOffset = run % 4 != 0;
            options.maxIterations = 30;
            const Estimate e = estimateMotion(force, position, options);
            QVERIFY(!e.message.isEmpty());
            if (!e.parameters)
                continue;
            QVERIFY2(e.parameters->vector().allFinite() && e.parameters->vector().minCoeff() > 0,
                     qPrintable(describeDuffing(e)));
            QVERIFY(std::isfinite(test::cubicOf(e)) && e.motion->covariance.allFinite());
            QVERIFY(std::isfinite(e.residuals.sse));
        }
    }
};

GRIPSCOPE_TEST(DuffingTest)
#include "duffing_test.moc"
