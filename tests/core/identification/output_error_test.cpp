// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::relativeDifference;
using test::Synthetic;

namespace {

OutputErrorOptions optionsFor(const Recording& recording, bool freeStart, bool freeOffset)
{
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = recording.hold.value_or(ForceHold::First);
    options.lag_s = recording.forceLag_s;
    options.freeInitialState = freeStart;
    options.freeOffset = freeOffset;
    return options;
}

Estimate estimate(const Recording& recording, bool freeStart, bool freeOffset)
{
    return estimateOutputError(recording.force, recording.position,
                               optionsFor(recording, freeStart, freeOffset));
}

QString describe(const Estimate& e)
{
    if (!e.parameters)
        return toString(e.status) + u": "_s + e.message.describe();
    return u"%1: m %2 b %3 k %4, %5 iterations"_s.arg(toString(e.status))
        .arg(e.parameters->m, 0, 'g', 15)
        .arg(e.parameters->b, 0, 'g', 15)
        .arg(e.parameters->k, 0, 'g', 15)
        .arg(e.iterations);
}

} // namespace

class OutputErrorTest : public QObject {
    Q_OBJECT
private slots:
    void withoutNoiseTheTruthComesBack_data()
    {
        QTest::addColumn<double>("damping");
        QTest::addColumn<bool>("straight");
        QTest::addColumn<double>("lag");
        QTest::addColumn<bool>("moving");
        for (const double damping : {0.02, 0.3, 1.0, 1.08, 5.0}) {
            for (const bool straight : {false, true}) {
                for (const double lag : {0.0, 0.4, 3.0, 2.7, -1.3}) {
                    for (const bool moving : {false, true})
                        QTest::addRow("damping %g, %s, lag %g samples, %s", damping, straight ? "foh" : "zoh",
                                      lag, moving ? "free start and offset" : "rest")
                            << damping << straight << lag << moving;
                }
            }
        }
    }
    void withoutNoiseTheTruthComesBack()
    {
        QFETCH(double, damping);
        QFETCH(bool, straight);
        QFETCH(double, lag);
        QFETCH(bool, moving);
        Synthetic synthetic;
        const double w = 1.6;
        synthetic.truth = {0.04, 2 * damping * w * 0.04, w * w * 0.04};
        synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
        synthetic.lag_s = lag * synthetic.sampleTime_s;
        if (moving) {
            synthetic.x0 = 2;
            synthetic.v0 = -3;
            synthetic.offset = 50;
        }
        const Recording recording = synthetic.make();
        const Estimate e = estimate(recording, moving, moving);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describe(e)));
        QVERIFY2(relativeDifference(*e.parameters, synthetic.truth) < 1e-9, qPrintable(describe(e)));
        QVERIFY(e.fit.simulationPercent.value_or(0) > 100 - 1e-8);
        if (moving) {
            QVERIFY(std::abs(*e.nuisance.x0 - 2) < 1e-8);
            QVERIFY(std::abs(*e.nuisance.v0 + 3) < 1e-7);
            QVERIFY(std::abs(*e.nuisance.offset - 50) < 1e-8);
        }
        QCOMPARE(e.simulated.size(), recording.size());
        QCOMPARE(e.residual.size(), recording.size());
    }

    void startsTenTimesOffFindTheSameAnswer_data()
    {
        QTest::addColumn<double>("m");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("k");
        for (const double m : {0.1, 1.0, 10.0}) {
            for (const double b : {0.1, 1.0, 10.0}) {
                for (const double k : {0.1, 1.0, 10.0})
                    QTest::addRow("m x%g, b x%g, k x%g", m, b, k) << m << b << k;
            }
        }
    }
    void startsTenTimesOffFindTheSameAnswer()
    {
        QFETCH(double, m);
        QFETCH(double, b);
        QFETCH(double, k);
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        const Recording recording = synthetic.make();
        OutputErrorOptions options = optionsFor(recording, true, true);
        const Estimate own = estimateOutputError(recording.force, recording.position, options);
        options.start =
            MassDampingStiffness{m * synthetic.truth.m, b * synthetic.truth.b, k * synthetic.truth.k};
        const Estimate e = estimateOutputError(recording.force, recording.position, options);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describe(e)));
        QVERIFY2(relativeDifference(*e.parameters, *own.parameters) < 1e-8, qPrintable(describe(e)));
    }

    void anyObjectIsFoundFromTheDataAlone()
    {
        // Natural frequencies from a tenth of a swing a record to near half the sample rate, any damping, any
        // hold: the search from the data must end no higher than the search from the truth.
        GaussianNoise random(42);
        int lost = 0;
        for (std::uint64_t run = 0; run < 300; ++run) {
            Synthetic synthetic;
            const double w = std::pow(10, -2.5 + 2.9 * random.uniform());
            const double damping = std::pow(10, -2 + 3 * random.uniform());
            synthetic.truth = {1, 2 * damping * w, w * w};
            synthetic.hold = random.uniform() < 0.5 ? ForceHold::Zero : ForceHold::First;
            synthetic.sampleTime_s = 1;
            synthetic.samples = static_cast<std::size_t>(std::pow(10, 1.6 + 1.4 * random.uniform()));
            synthetic.bit_s = std::clamp(2.5 / w, 1.0, static_cast<double>(synthetic.samples) / 8);
            synthetic.offset = 3 / synthetic.truth.k;
            synthetic.fitPercent = 95;
            synthetic.seed = run;
            const Recording recording = synthetic.make();
            OutputErrorOptions options = optionsFor(recording, true, true);
            const Estimate own = estimateOutputError(recording.force, recording.position, options);
            options.start = synthetic.truth;
            const Estimate fromTruth = estimateOutputError(recording.force, recording.position, options);
            QVERIFY2(own.status != EstimateStatus::NotConverged, qPrintable(describe(own)));
            if (fromTruth.status == EstimateStatus::Converged)
                lost += own.status != EstimateStatus::Converged ||
                                own.residuals.sse > fromTruth.residuals.sse * (1 + 1e-6)
                            ? 1
                            : 0;
        }
        QVERIFY2(lost <= 1, qPrintable(QString::number(lost))); // 4 of 10,000 in a wider trial
    }

    void unitsChangeNothingButUnits_data()
    {
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("position");
        QTest::addColumn<double>("time");
        for (const double force : {1e-6, 1e6, 1e70}) {
            for (const double position : {1e-6, 1e6, 1e-70})
                QTest::addRow("force %g, position %g", force, position) << force << position << 1.0;
        }
        QTest::newRow("fast") << 1.0 << 1.0 << 1e-6;
        QTest::newRow("slow") << 1.0 << 1.0 << 1e6;
        QTest::newRow("SI can") << 10.0 << 1e-3 << 3.2e-3;
    }
    void unitsChangeNothingButUnits()
    {
        QFETCH(double, force);
        QFETCH(double, position);
        QFETCH(double, time);
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        Recording recording = synthetic.make();
        const Estimate e = estimate(recording, true, true);
        for (double& f : recording.force)
            f *= force;
        for (double& y : recording.position)
            y *= position;
        recording.sampleTime_s *= time;
        const Estimate scaled = estimate(recording, true, true);
        QVERIFY2(scaled.status == EstimateStatus::Converged, qPrintable(describe(scaled)));
        // Powers of ten round, which moves the optimum by a rounding error times the condition (about 100).
        const double unit = force / position;
        const MassDampingStiffness back{scaled.parameters->m / unit / time / time,
                                        scaled.parameters->b / unit / time, scaled.parameters->k / unit};
        QVERIFY2(relativeDifference(back, *e.parameters) < 1e-9, qPrintable(describe(scaled)));
        const double error = (*scaled.standardErrors())(2) / unit;
        QVERIFY(std::abs(error / (*e.standardErrors())(2) - 1) < 1e-6);
    }

    void anyNumberOfSamplesWorks_data()
    {
        QTest::addColumn<int>("samples");
        for (const int samples : {7, 8, 12, 20, 50, 127, 128, 2000, 20000, 300000})
            QTest::addRow("%d", samples) << samples;
    }
    void anyNumberOfSamplesWorks()
    {
        QFETCH(int, samples);
        Synthetic synthetic;
        synthetic.samples = static_cast<std::size_t>(samples);
        synthetic.bit_s = samples < 100 ? 0.1 : 0.5;
        synthetic.fitPercent = samples < 20 ? 100 : 99;
        synthetic.seed = 3;
        const Estimate e = estimate(synthetic.make(), true, true);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describe(e)));
        const Eigen::Vector3d miss = e.parameters->vector() - synthetic.truth.vector();
        if (samples < 20)
            QVERIFY2(relativeDifference(*e.parameters, synthetic.truth) < 1e-6, qPrintable(describe(e)));
        else // five standard errors, and those shrink with the number of samples
            QVERIFY2((miss.cwiseAbs() - 5 * *e.standardErrors()).maxCoeff() < 0, qPrintable(describe(e)));
    }

    void finelySampledObjectsKeepTheirDigits()
    {
        // wn T = 0.0016 over ten swings: neighbouring samples hardly differ.
        Synthetic synthetic;
        synthetic.sampleTime_s = 0.001;
        synthetic.samples = 40000;
        const Estimate e = estimate(synthetic.make(), true, true);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describe(e)));
        QVERIFY2(relativeDifference(*e.parameters, synthetic.truth) < 1e-8, qPrintable(describe(e)));
    }

    void theErrorsCountEveryFreeUnknown()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        const Recording recording = synthetic.make();
        QCOMPARE(estimate(recording, true, true).residuals.degreesOfFreedom, 394.0);
        QCOMPARE(estimate(recording, true, false).residuals.degreesOfFreedom, 395.0);
        QCOMPARE(estimate(recording, false, true).residuals.degreesOfFreedom, 396.0);
        QCOMPARE(estimate(recording, false, false).residuals.degreesOfFreedom, 397.0);
    }
    void whatIsFixedIsNotReported()
    {
        const Estimate e = estimate(Synthetic().make(), false, false);
        QVERIFY(!e.nuisance.x0 && !e.nuisance.v0 && !e.nuisance.offset);
        QVERIFY(!e.coefficients);
    }
    void theCovarianceIsThatOfDifferencesOfTheCost()
    {
        // (J'J)^-1 from second differences of the cost on noise-free data, where the Hessian is 2 J'J.
        Synthetic synthetic;
        Recording recording = synthetic.make();
        const auto cost = [&](const Eigen::Vector3d& p) {
            const std::vector<double> x =
                simulate({p(0), p(1), p(2)}, recording.force, {0.05, ForceHold::Zero, 0, 0, 0, 0});
            double sum = 0;
            for (std::size_t i = 0; i < x.size(); ++i)
                sum += (x[i] - recording.position[i]) * (x[i] - recording.position[i]);
            return sum;
        };
        const Eigen::Vector3d truth = synthetic.truth.vector();
        const Eigen::Vector3d step = 1e-4 * truth;
        Eigen::Matrix3d information;
        for (Eigen::Index i = 0; i < 3; ++i) {
            for (Eigen::Index j = 0; j < 3; ++j) {
                const Eigen::Vector3d a = step(i) * Eigen::Vector3d::Unit(i);
                const Eigen::Vector3d b = step(j) * Eigen::Vector3d::Unit(j);
                information(i, j) =
                    (cost(truth + a + b) - cost(truth + a - b) - cost(truth - a + b) + cost(truth - a - b)) /
                    (8 * step(i) * step(j));
            }
        }
        synthetic.fitPercent = 99.999;
        recording = synthetic.make();
        const Estimate e = estimate(recording, false, false);
        const double variance = e.residuals.sse / e.residuals.degreesOfFreedom;
        const Eigen::Matrix3d product = *e.covariance * information / variance;
        QVERIFY((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-3);
    }

    void whatTheDataCannotTellIsSaidSo_data()
    {
        QTest::addColumn<int>("record");
        QTest::addColumn<QString>("status");
        QTest::addColumn<QString>("word");
        QTest::newRow("lone step, all free") << 0 << u"not_identifiable"_s << u"constant force"_s;
        QTest::newRow("constant position") << 1 << u"not_identifiable"_s << u"does not change"_s;
        QTest::newRow("no force") << 2 << u"not_identifiable"_s << u"constant force"_s;
        QTest::newRow("six samples") << 3 << u"too_few_samples"_s << u"fewer samples"_s;
        QTest::newRow("no samples") << 4 << u"too_few_samples"_s << u"fewer samples"_s;
        QTest::newRow("lag longer than the record") << 5 << u"too_few_samples"_s << u"lag"_s;
        QTest::newRow("position runs against the force") << 6 << u"not_identifiable"_s << u""_s;
    }
    void whatTheDataCannotTellIsSaidSo()
    {
        QFETCH(int, record);
        QFETCH(QString, status);
        QFETCH(QString, word);
        Synthetic synthetic;
        if (record == 0)
            synthetic.kind = ExcitationKind::Step;
        if (record == 2) {
            synthetic.peak = 0;
            synthetic.x0 = 1;
        }
        if (record == 3)
            synthetic.samples = 6;
        Recording recording = synthetic.make();
        if (record == 1)
            std::fill(recording.position.begin(), recording.position.end(), 3.25);
        if (record == 4) {
            recording.force.clear();
            recording.position.clear();
        }
        if (record == 5)
            recording.forceLag_s = 1e20;
        if (record == 6) {
            for (double& y : recording.position)
                y = -y;
        }
        const Estimate e = estimate(recording, true, true);
        QCOMPARE(toString(e.status), status);
        QVERIFY2(e.message.describe().contains(word), qPrintable(e.message.describe()));
        QVERIFY(!e.parameters && !e.covariance);
    }
    void aLoneStepFromRestIsEnough()
    {
        Synthetic synthetic;
        synthetic.kind = ExcitationKind::Step;
        const Estimate e = estimate(synthetic.make(), false, false);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describe(e)));
        QVERIFY(relativeDifference(*e.parameters, synthetic.truth) < 1e-9);
    }
    void aRingingObjectUnderConstantForceIsEnoughWithoutOffset()
    {
        Synthetic synthetic;
        synthetic.truth = {0.04, 0.02, 0.1};
        synthetic.kind = ExcitationKind::Step;
        synthetic.x0 = 3;
        const Estimate e = estimate(synthetic.make(), true, false);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describe(e)));
        QVERIFY(relativeDifference(*e.parameters, synthetic.truth) < 1e-8);
    }
    void pureNoiseGivesNoNonsense()
    {
        Recording recording = Synthetic().make();
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            GaussianNoise noise(seed);
            for (double& y : recording.position)
                y = noise();
            const Estimate e = estimate(recording, true, true);
            if (!e.parameters)
                continue;
            QVERIFY(e.parameters->vector().allFinite() && e.parameters->vector().minCoeff() > 0);
            QVERIFY(e.fit.simulationPercent.value_or(0) < 30);
        }
    }
    void theWrongHoldCostsLikelihood()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 95;
        const Recording recording = synthetic.make();
        const OutputErrorOptions options = optionsFor(recording, true, true);
        const Estimate e = estimateOutputError(recording.force, recording.position, options);
        OutputErrorOptions wrong = options;
        wrong.hold = ForceHold::First;
        const Estimate direct = estimateOutputError(recording.force, recording.position, wrong);
        QVERIFY(direct.residuals.sse > e.residuals.sse);
    }
};

GRIPSCOPE_TEST(OutputErrorTest)
#include "output_error_test.moc"
