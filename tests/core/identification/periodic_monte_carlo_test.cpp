// SPDX-License-Identifier: GPL-3.0-or-later
// Repeated experiments with known truth: the errors of the periodic estimate and what it says of them.
#include "core/identification/output_error/output_error.h"
#include "core/identification/periodic/periodic.h"
#include "tests/core/identification/controlled_gripper.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>

#include <functional>

using namespace gripscope;
using test::ControlledGripper;
using test::Synthetic;

namespace {

/// A true program fails a check of this file once in this many runs of all seeds; the seeds are fixed.
constexpr double periodicFalseAlarm = 1e-4;
constexpr int runs = 150;

struct PeriodicTally {
    Eigen::Vector3d bias = Eigen::Vector3d::Zero(), square = Eigen::Vector3d::Zero(); ///< relative errors
    Eigen::Vector3d covered = Eigen::Vector3d::Zero(); ///< share of the 95 % intervals that hold the truth
    int misfits = 0;                                   ///< p-values of the cost below 1 %
    int converged = 0;
};

PeriodicTally repeat(const std::function<Recording(std::uint64_t)>& make, const MassDampingStiffness& truth,
                     Estimator estimator = Estimator::Periodic)
{
    PeriodicTally tally;
    for (int run = 1; run <= runs; ++run) {
        const Recording recording = make(static_cast<std::uint64_t>(run));
        Estimate e;
        if (estimator == Estimator::Periodic) {
            PeriodicOptions options;
            options.sampleTime_s = recording.sampleTime_s;
            options.hold = *recording.hold;
            e = estimatePeriodic(recording.force, recording.position, options);
        } else {
            OutputErrorOptions options;
            options.sampleTime_s = recording.sampleTime_s;
            options.hold = *recording.hold;
            e = estimateOutputError(recording.force, recording.position, options);
        }
        if (e.status != EstimateStatus::Converged)
            continue;
        const Eigen::Vector3d error = e.parameters->vector() - truth.vector();
        const Eigen::Vector3d relative = error.cwiseQuotient(truth.vector());
        tally.bias += relative / runs;
        tally.square += relative.cwiseAbs2() / runs;
        const Eigen::Vector3d z = error.cwiseQuotient(*e.standardErrors());
        for (Eigen::Index i = 0; i < 3; ++i)
            tally.covered(i) += std::abs(z(i)) < 1.959964 ? 1.0 / runs : 0;
        tally.misfits += e.residuals.inputIndependenceP.value_or(1) < 0.01 ? 1 : 0;
        ++tally.converged;
    }
    return tally;
}

/// Intervals that cover `promised` of the time miss no more often than this.
double lowestCoverage(double promised)
{
    const boost::math::binomial misses(runs, 1 - promised);
    return 1 - boost::math::quantile(boost::math::complement(misses, periodicFalseAlarm)) / runs;
}

std::string words(const PeriodicTally& tally)
{
    QString text;
    for (Eigen::Index i = 0; i < 3; ++i)
        text += QStringLiteral("bias %1 %, rmse %2 %, covered %3 %; ")
                    .arg(100 * tally.bias(i))
                    .arg(100 * std::sqrt(tally.square(i)))
                    .arg(100 * tally.covered(i));
    return text.toStdString();
}

} // namespace

class PeriodicMonteCarloTest : public QObject {
    Q_OBJECT
private slots:
    void driftUnderForceFeedbackHardlyBiasesAndIsCovered()
    {
        // A random walk of 10 % of the command's peak, to which a stiff drive and a servo answer.
        const ControlledGripper gripper;
        const auto make = [&](std::uint64_t seed) {
            ControlledGripper one = gripper;
            one.seed = seed;
            return one.make();
        };
        const PeriodicTally periodic = repeat(make, gripper.truth);
        QCOMPARE(periodic.converged, runs);
        QVERIFY2(std::abs(periodic.bias(2)) < 0.01, words(periodic).c_str());
        QVERIFY2(periodic.covered.minCoeff() > 0.92, words(periodic).c_str());
        // What takes the force for independent of the position fails here; else this test would show nothing.
        const PeriodicTally outputError = repeat(make, gripper.truth, Estimator::OutputError);
        QVERIFY2(outputError.covered(2) < 0.6, words(outputError).c_str());
        QVERIFY2(outputError.square(2) > 4 * periodic.square(2), words(outputError).c_str());
    }

    void aStraightDriftIsTakenOut()
    {
        ControlledGripper gripper;
        gripper.straightDrift = true;
        gripper.positionNoise = 0.02;
        const PeriodicTally tally = repeat(
            [&](std::uint64_t seed) {
                gripper.seed = seed;
                return gripper.make();
            },
            gripper.truth);
        QCOMPARE(tally.converged, runs);
        QVERIFY2(tally.covered.minCoeff() >= lowestCoverage(0.94), words(tally).c_str());
        QVERIFY2(tally.bias.cwiseAbs().maxCoeff() < 0.001, words(tally).c_str());
    }

    void whiteNoiseCostsLittleOverTheBound()
    {
        // Output error reaches the bound (its own tests); the errors of both come from the same records.
        Synthetic synthetic;
        synthetic.kind = ExcitationKind::InverseRepeat;
        synthetic.bit_s = 0.2;
        synthetic.samples = 1984;
        synthetic.fitPercent = 90;
        const auto make = [&](std::uint64_t seed) {
            synthetic.seed = seed;
            return synthetic.make();
        };
        const PeriodicTally periodic = repeat(make, synthetic.truth);
        const PeriodicTally bound = repeat(make, synthetic.truth, Estimator::OutputError);
        QCOMPARE(periodic.converged, runs);
        QVERIFY2(periodic.covered.minCoeff() >= lowestCoverage(0.94), words(periodic).c_str());
        // Leakage and noise cost degrees of freedom: 10 % in the errors; 10 % for chance, the errors being
        // correlated.
        const Eigen::Vector3d ratio = periodic.square.cwiseQuotient(bound.square).cwiseSqrt();
        QVERIFY2(ratio.mean() < 1.2, words(periodic).c_str());
        const boost::math::binomial misfits(runs, 0.01);
        QVERIFY(periodic.misfits <=
                boost::math::quantile(boost::math::complement(misfits, periodicFalseAlarm)));
    }

    void noiseOnTheMeasuredForceIsCovered()
    {
        Synthetic synthetic;
        synthetic.kind = ExcitationKind::InverseRepeat;
        synthetic.bit_s = 0.2;
        synthetic.samples = 1984;
        synthetic.fitPercent = 98;
        const auto make = [&](std::uint64_t seed) {
            synthetic.seed = seed;
            Recording recording = synthetic.make();
            GaussianNoise random(seed + 9000);
            for (double& f : recording.force)
                f += 0.1 * random();
            return recording;
        };
        const PeriodicTally tally = repeat(make, synthetic.truth);
        QCOMPARE(tally.converged, runs);
        QVERIFY2(tally.covered.minCoeff() >= lowestCoverage(0.94), words(tally).c_str());
        QVERIFY2(tally.bias.cwiseAbs().maxCoeff() < 0.005, words(tally).c_str());
    }
};

GRIPSCOPE_TEST(PeriodicMonteCarloTest)
#include "periodic_monte_carlo_test.moc"
