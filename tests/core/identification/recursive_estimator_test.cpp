// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error.h"
#include "core/identification/recursive/recursive_estimator.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>

#include <limits>

using namespace gripscope;
using test::Synthetic;

namespace {

/// What curvature leaves of the last step, in standard errors of the batch (0.05 at 15 % noise at most).
constexpr double fractionOfAnError = 0.1;

Synthetic squeeze(ForceHold hold, double fitPercent, std::uint64_t seed)
{
    Synthetic synthetic;
    synthetic.hold = hold;
    synthetic.fitPercent = fitPercent;
    synthetic.seed = seed;
    synthetic.samples = 1000;
    synthetic.x0 = 1;
    synthetic.v0 = -2;
    synthetic.offset = 5;
    return synthetic;
}

RecursiveOptions recursiveOptions(const Recording& recording)
{
    RecursiveOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = *recording.hold;
    options.lag_s = recording.forceLag_s;
    return options;
}

RecursiveEstimator followed(const Recording& recording, const RecursiveOptions& options)
{
    RecursiveEstimator estimator(options);
    for (std::size_t i = 0; i < recording.force.size(); ++i)
        estimator.update(recording.force[i], recording.position[i]);
    return estimator;
}

Estimate batch(const Recording& recording)
{
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = *recording.hold;
    options.lag_s = recording.forceLag_s;
    return estimateOutputError(recording.force, recording.position, options);
}

bool allFinite(const RecursiveState& state)
{
    return std::isfinite(state.noiseDeviation) &&
           (!state.parameters || state.parameters->vector().allFinite()) &&
           (!state.covariance || state.covariance->allFinite()) &&
           std::isfinite(state.nuisance.x0.value_or(0)) && std::isfinite(state.nuisance.v0.value_or(0)) &&
           std::isfinite(state.nuisance.offset.value_or(0));
}

} // namespace

class RecursiveEstimatorTest : public QObject {
    Q_OBJECT
private slots:
    void itEndsWhereTheBatchEnds_data()
    {
        QTest::addColumn<bool>("held");
        QTest::addColumn<double>("fit");
        for (const bool held : {true, false}) {
            QTest::addRow("85 %%, held %d", held) << held << 85.0;
            QTest::addRow("97 %%, held %d", held) << held << 97.0;
        }
    }
    void itEndsWhereTheBatchEnds()
    {
        QFETCH(bool, held);
        QFETCH(double, fit);
        const ForceHold hold = held ? ForceHold::Zero : ForceHold::First;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Recording recording = squeeze(hold, fit, seed).make();
            const RecursiveState state = followed(recording, recursiveOptions(recording)).state();
            const Estimate whole = batch(recording);
            QVERIFY(state.status == RecursiveStatus::Following);
            const Eigen::Vector3d errors = *whole.standardErrors();
            const Eigen::Vector3d apart =
                (state.parameters->vector() - whole.parameters->vector()).cwiseQuotient(errors);
            QVERIFY2(apart.cwiseAbs().maxCoeff() < fractionOfAnError,
                     qPrintable(QString::number(apart.cwiseAbs().maxCoeff())));
            const Eigen::Vector3d ratio = state.covariance->diagonal().cwiseSqrt().cwiseQuotient(errors);
            QVERIFY((ratio.array() - 1).abs().maxCoeff() < 0.03);
            QVERIFY(std::abs(*state.nuisance.offset - *whole.nuisance.offset) < 0.1 * errors.norm() + 0.01);
            QVERIFY(std::abs(state.noiseDeviation /
                                 std::sqrt(whole.residuals.sse / whole.residuals.degreesOfFreedom) -
                             1) < 0.01);
        }
    }
    void aLagBetweenTheChannelsIsFollowed_data()
    {
        QTest::addColumn<bool>("held");
        QTest::addColumn<double>("samples");
        for (const bool held : {true, false}) {
            for (const double samples : {0.4, 1.0, 2.7, -0.3, -2.0})
                QTest::addRow("%g samples, held %d", samples, held) << held << samples;
        }
    }
    void aLagBetweenTheChannelsIsFollowed()
    {
        QFETCH(bool, held);
        QFETCH(double, samples);
        Synthetic synthetic = squeeze(held ? ForceHold::Zero : ForceHold::First, 90, 7);
        synthetic.lag_s = samples * synthetic.sampleTime_s;
        const Recording recording = synthetic.make();
        const RecursiveState state = followed(recording, recursiveOptions(recording)).state();
        const Estimate whole = batch(recording);
        QVERIFY(state.status == RecursiveStatus::Following);
        const Eigen::Vector3d apart =
            (state.parameters->vector() - whole.parameters->vector()).cwiseQuotient(*whole.standardErrors());
        QVERIFY2(apart.cwiseAbs().maxCoeff() < fractionOfAnError,
                 qPrintable(QString::number(apart.cwiseAbs().maxCoeff())));
        // Without noise both are exact.
        synthetic.fitPercent = 100;
        const Recording clean = synthetic.make();
        const RecursiveState exact = followed(clean, recursiveOptions(clean)).state();
        QVERIFY(test::relativeDifference(*exact.parameters, synthetic.truth) < 1e-6);
    }
    void aStartThatIsWrongByTenTimesChangesNothing_data()
    {
        QTest::addColumn<double>("m");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("k");
        QTest::newRow("all ten times too large") << 10.0 << 10.0 << 10.0;
        QTest::newRow("all ten times too small") << 0.1 << 0.1 << 0.1;
        QTest::newRow("slow and ringing") << 10.0 << 0.1 << 0.1;
        QTest::newRow("fast and creeping") << 0.1 << 10.0 << 10.0;
        QTest::newRow("hardly damped") << 10.0 << 0.1 << 10.0;
    }
    void aStartThatIsWrongByTenTimesChangesNothing()
    {
        QFETCH(double, m);
        QFETCH(double, b);
        QFETCH(double, k);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const Synthetic synthetic = squeeze(ForceHold::Zero, 85, seed);
            const Recording recording = synthetic.make();
            RecursiveOptions options = recursiveOptions(recording);
            options.start = {m * synthetic.truth.m, b * synthetic.truth.b, k * synthetic.truth.k};
            const RecursiveState state = followed(recording, options).state();
            QVERIFY(state.status == RecursiveStatus::Following);
            const Estimate whole = batch(recording);
            QVERIFY(((state.parameters->vector() - whole.parameters->vector())
                         .cwiseQuotient(*whole.standardErrors())
                         .cwiseAbs()
                         .maxCoeff()) < fractionOfAnError);
        }
    }
    void itsCovarianceIsHonestAllTheWay_data()
    {
        QTest::addColumn<int>("samples");
        QTest::newRow("150 samples") << 150;
        QTest::newRow("400 samples") << 400;
    }
    void itsCovarianceIsHonestAllTheWay()
    {
        QFETCH(int, samples);
        constexpr int runs = 200;
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        int covered = 0, following = 0;
        for (int run = 0; run < runs; ++run) {
            Synthetic synthetic = squeeze(ForceHold::Zero, 92, static_cast<std::uint64_t>(run) + 1);
            synthetic.samples = static_cast<std::size_t>(samples);
            const Recording recording = synthetic.make();
            const RecursiveState state = followed(recording, recursiveOptions(recording)).state();
            if (state.status != RecursiveStatus::Following)
                continue;
            ++following;
            const Eigen::Vector3d z = (state.parameters->vector() - synthetic.truth.vector())
                                          .cwiseQuotient(state.covariance->diagonal().cwiseSqrt());
            squares += z.cwiseAbs2();
            covered += static_cast<int>((z.array().abs() < 1.976).count()); // Student, 144 degrees of freedom
        }
        // A few squeezes have just moved the point when they end; they say so.
        QVERIFY2(following > 0.96 * runs, qPrintable(QString::number(following)));
        // Chi-square with one degree of freedom a run, one false alarm in 10,000; curvature and the
        // linearised last step are allowed 5 % in the root.
        const boost::math::chi_squared sum(following);
        const double lowest = boost::math::quantile(sum, 1e-4);
        const double highest = 1.05 * 1.05 * boost::math::quantile(boost::math::complement(sum, 1e-4));
        for (Eigen::Index i = 0; i < 3; ++i)
            QVERIFY2(squares(i) > lowest && squares(i) < highest,
                     qPrintable(QString::number(std::sqrt(squares(i) / following))));
        // The three intervals of a run are correlated: counted as one run's worth.
        const boost::math::binomial misses(following, 0.05);
        QVERIFY(following - covered / 3.0 <= boost::math::quantile(boost::math::complement(misses, 1e-4)));
    }
    void withoutNoiseItIsExact()
    {
        const Synthetic synthetic = squeeze(ForceHold::First, 100, 1);
        const Recording recording = synthetic.make();
        const RecursiveState state = followed(recording, recursiveOptions(recording)).state();
        QVERIFY(state.status == RecursiveStatus::Following);
        QVERIFY(test::relativeDifference(*state.parameters, synthetic.truth) < 1e-7);
        QVERIFY(std::abs(*state.nuisance.x0 - synthetic.x0) < 1e-5);
        QVERIFY(std::abs(*state.nuisance.v0 - synthetic.v0) < 1e-5);
        QVERIFY(std::abs(*state.nuisance.offset - synthetic.offset) < 1e-6);
    }
    void unitsDoNotMatter()
    {
        const Recording plain = squeeze(ForceHold::Zero, 90, 3).make();
        const RecursiveState reference = followed(plain, recursiveOptions(plain)).state();
        for (const double scale : {1e-6, 1e6}) {
            Recording scaled = plain;
            scaled.sampleTime_s *= scale;
            for (double& y : scaled.position)
                y /= scale;
            const RecursiveState state = followed(scaled, recursiveOptions(scaled)).state();
            const Eigen::Vector3d units(scale * scale * scale, scale * scale, scale);
            QVERIFY(state.status == RecursiveStatus::Following);
            const Eigen::Vector3d want = reference.parameters->vector().cwiseProduct(units);
            QVERIFY((state.parameters->vector() - want).cwiseQuotient(want).cwiseAbs().maxCoeff() < 1e-6);
        }
    }
    void aForceThatDoesNotTellIsWaitedOut()
    {
        Synthetic synthetic = squeeze(ForceHold::Zero, 95, 1);
        const Recording recording = synthetic.make();
        RecursiveEstimator estimator(recursiveOptions(recording));
        GaussianNoise noise(9);
        for (int i = 0; i < 500; ++i) {
            estimator.update(2, 5 + 0.01 * noise());
            QVERIFY(estimator.state().status == RecursiveStatus::Waiting);
            QVERIFY(!estimator.state().parameters);
        }
        QCOMPARE(estimator.state().samples, 500U);
        // From rest at the force it was held with, the squeeze begins.
        std::vector<double> force(500, 2.0);
        force.insert(force.end(), recording.force.begin(), recording.force.end());
        const std::vector<double> position =
            simulate(synthetic.truth, force, {0.05, ForceHold::Zero, 0, 2 / synthetic.truth.k, 0, 0});
        RecursiveEstimator second(recursiveOptions(recording));
        for (std::size_t i = 0; i < force.size(); ++i)
            second.update(force[i], position[i] + 0.1 * noise());
        QVERIFY(second.state().status == RecursiveStatus::Following);
        QVERIFY(test::relativeDifference(*second.state().parameters, synthetic.truth) < 0.1);
    }
    void lostPositionsDoNotShiftIt()
    {
        constexpr int runs = 60;
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (int run = 0; run < runs; ++run) {
            const Synthetic synthetic = squeeze(ForceHold::Zero, 90, static_cast<std::uint64_t>(run) + 1);
            Recording recording = synthetic.make();
            GaussianNoise chance(static_cast<std::uint64_t>(run) + 500);
            for (std::size_t i = 1; i < recording.position.size(); ++i)
                if (chance.uniform() < 0.1)
                    recording.position[i] = std::numeric_limits<double>::quiet_NaN();
            const RecursiveState state = followed(recording, recursiveOptions(recording)).state();
            QVERIFY(state.status == RecursiveStatus::Following);
            mean += (state.parameters->vector() - synthetic.truth.vector())
                        .cwiseQuotient(state.covariance->diagonal().cwiseSqrt()) /
                    runs;
        }
        // The mean of 60 standard normal numbers exceeds 4 / sqrt(60) once in 15,000.
        QVERIFY(mean.cwiseAbs().maxCoeff() < 4 / std::sqrt(60.0));
    }
    void whatIsNotKeptStillCounts()
    {
        Synthetic synthetic = squeeze(ForceHold::Zero, 85, 2);
        synthetic.samples = 4000;
        const Recording recording = synthetic.make();
        RecursiveOptions options = recursiveOptions(recording);
        options.keptSamples = 1500;
        const RecursiveState state = followed(recording, options).state();
        const Estimate whole = batch(recording);
        QVERIFY(state.status == RecursiveStatus::Following);
        // The linearisation is that of 1,500 samples: its errors are 1.6 times those of 4,000.
        QVERIFY(((state.parameters->vector() - whole.parameters->vector())
                     .cwiseQuotient(*whole.standardErrors())
                     .cwiseAbs()
                     .maxCoeff()) < 3 * fractionOfAnError);
    }
    void aCopyGoesItsOwnWay()
    {
        const Recording recording = squeeze(ForceHold::Zero, 90, 4).make();
        RecursiveEstimator first = followed(recording, recursiveOptions(recording));
        const RecursiveEstimator copy = first;
        const Eigen::Vector3d before = copy.state().parameters->vector();
        for (int i = 0; i < 100; ++i)
            first.update(1, 100);
        QCOMPARE(copy.state().parameters->vector(), before);
        QVERIFY(!first.state().parameters || first.state().parameters->vector() != before);
    }
    void noInputMakesItSayNonsense()
    {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        constexpr double infinity = std::numeric_limits<double>::infinity();
        GaussianNoise noise(1);
        for (const double force : {0.0, 1e-300, 1e300, nan, infinity}) {
            for (const double position : {0.0, 1e-300, 1e300, nan, -infinity}) {
                RecursiveOptions options;
                options.sampleTime_s = 0.01;
                RecursiveEstimator estimator(options);
                for (int i = 0; i < 200; ++i) {
                    estimator.update(force * noise(), position * noise());
                    QVERIFY(allFinite(estimator.state()));
                }
            }
        }
        for (const double lag_s : {1e300, -1e300, nan, 1e6, -1e6}) {
            RecursiveOptions options;
            options.sampleTime_s = 0.01;
            options.lag_s = lag_s;
            RecursiveEstimator estimator(options);
            for (int i = 0; i < 200; ++i)
                estimator.update(noise(), noise());
            QVERIFY(allFinite(estimator.state()));
        }
        for (const double sampleTime_s : {0.0, -1.0, nan, infinity}) {
            RecursiveOptions options;
            options.sampleTime_s = sampleTime_s;
            RecursiveEstimator estimator(options);
            estimator.update(1, 1);
            QVERIFY(estimator.state().status == RecursiveStatus::Waiting);
        }
    }
};

GRIPSCOPE_TEST(RecursiveEstimatorTest)
#include "recursive_estimator_test.moc"
