// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/instrumental/instrumental_variables.h"
#include "core/identification/output_error/output_error.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::relativeDifference;
using test::Synthetic;

namespace {

InstrumentalVariablesOptions instrumentalOptions(const Recording& recording, bool free)
{
    InstrumentalVariablesOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = recording.hold.value_or(ForceHold::First);
    options.lag_s = recording.forceLag_s;
    options.freeInitialState = free;
    options.freeOffset = free;
    return options;
}

Estimate instrumentalEstimate(const Recording& recording, bool free)
{
    return estimateInstrumentalVariables(recording.force, recording.position,
                                         instrumentalOptions(recording, free));
}

Estimate outputError(const Recording& recording, bool free)
{
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = recording.hold.value_or(ForceHold::First);
    options.lag_s = recording.forceLag_s;
    options.freeInitialState = free;
    options.freeOffset = free;
    return estimateOutputError(recording.force, recording.position, options);
}

QString describeInstrumental(const Estimate& e)
{
    if (!e.parameters)
        return toString(e.status) + u": "_s + e.message.describe();
    return u"%1: m %2 b %3 k %4, %5 iterations"_s.arg(toString(e.status))
        .arg(e.parameters->m, 0, 'g', 12)
        .arg(e.parameters->b, 0, 'g', 12)
        .arg(e.parameters->k, 0, 'g', 12)
        .arg(e.iterations);
}

} // namespace

class InstrumentalVariablesTest : public QObject {
    Q_OBJECT
private slots:
    void withoutNoiseTheTruthComesBack_data()
    {
        QTest::addColumn<double>("damping");
        QTest::addColumn<bool>("straight");
        QTest::addColumn<double>("lag");
        QTest::addColumn<bool>("moving");
        for (const double damping : {0.02, 1.0, 1.08, 5.0}) {
            for (const bool straight : {false, true}) {
                for (const double lag : {0.0, 0.4, 3.0, -1.3}) {
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
        const Estimate e = instrumentalEstimate(recording, moving);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describeInstrumental(e)));
        QVERIFY2(relativeDifference(*e.parameters, synthetic.truth) < 1e-9,
                 qPrintable(describeInstrumental(e)));
        QVERIFY(e.fit.simulationPercent.value_or(0) > 100 - 1e-8);
        QCOMPARE(e.simulated.size(), recording.size());
        QCOMPARE(e.residual.size(), recording.size());
        if (moving) {
            QVERIFY(std::abs(*e.nuisance.x0 - 2) < 1e-8);
            QVERIFY(std::abs(*e.nuisance.v0 + 3) < 1e-7);
            QVERIFY(std::abs(*e.nuisance.offset - 50) < 1e-8);
        }
    }

    void theFixedPointIsTheOutputErrorEstimate_data()
    {
        QTest::addColumn<double>("fit");
        QTest::addColumn<bool>("straight");
        QTest::addColumn<bool>("free");
        for (const double fit : {70.0, 90.0}) {
            for (const bool straight : {false, true}) {
                for (const bool free : {false, true})
                    QTest::addRow("fit %g, %s, %s", fit, straight ? "foh" : "zoh", free ? "free" : "rest")
                        << fit << straight << free;
            }
        }
    }
    void theFixedPointIsTheOutputErrorEstimate()
    {
        QFETCH(double, fit);
        QFETCH(bool, straight);
        QFETCH(bool, free);
        Synthetic synthetic;
        synthetic.fitPercent = fit;
        synthetic.samples = 600;
        synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
        const Recording recording = synthetic.make();
        const Estimate e = instrumentalEstimate(recording, free);
        const Estimate other = outputError(recording, free);
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describeInstrumental(e)));
        // Both end within 1e-8 standard errors of the same point; these are below a third.
        QVERIFY2(relativeDifference(*e.parameters, *other.parameters) < 1e-7,
                 qPrintable(describeInstrumental(e)));
        QVERIFY(std::abs(e.residuals.sse / other.residuals.sse - 1) < 1e-9);
        // The covariance replaces noise-free regressors by measured ones; filtered noise adds to these about
        // (1 - fit) / sqrt(N), here 1 %, times the correlation between the parameters (ten).
        for (Eigen::Index i = 0; i < 3; ++i)
            QVERIFY(std::abs((*e.standardErrors())(i) / (*other.standardErrors())(i)-1) < 0.15);
    }

    void startsTenTimesOffFindTheSameAnswer()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        const Recording recording = synthetic.make();
        const Estimate own = instrumentalEstimate(recording, true);
        for (const double m : {0.1, 1.0, 10.0}) {
            for (const double b : {0.1, 10.0}) {
                for (const double k : {0.1, 1.0, 10.0}) {
                    InstrumentalVariablesOptions options = instrumentalOptions(recording, true);
                    options.start = MassDampingStiffness{m * synthetic.truth.m, b * synthetic.truth.b,
                                                         k * synthetic.truth.k};
                    const Estimate e =
                        estimateInstrumentalVariables(recording.force, recording.position, options);
                    QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describeInstrumental(e)));
                    QVERIFY2(relativeDifference(*e.parameters, *own.parameters) < 1e-6,
                             qPrintable(describeInstrumental(e)));
                }
            }
        }
    }

    void errorsReachTheBoundWithoutOutliers_data()
    {
        QTest::addColumn<double>("fit");
        QTest::addColumn<int>("samples");
        QTest::newRow("85 %, 200 samples") << 85.0 << 200;
        QTest::newRow("90 %, 200 samples") << 90.0 << 200;
        QTest::newRow("95 %, 1000 samples") << 95.0 << 1000;
    }
    void errorsReachTheBoundWithoutOutliers()
    {
        QFETCH(double, fit);
        QFETCH(int, samples);
        constexpr int runs = 300;
        constexpr double falseAlarm = 1e-4;
        Eigen::Vector3d squared = Eigen::Vector3d::Zero();
        int covered = 0;
        for (int run = 0; run < runs; ++run) {
            Synthetic synthetic;
            synthetic.fitPercent = fit;
            synthetic.samples = static_cast<std::size_t>(samples);
            synthetic.seed = static_cast<std::uint64_t>(run) + 1;
            synthetic.x0 = 1;
            synthetic.v0 = -2;
            synthetic.offset = 5;
            const Estimate e = instrumentalEstimate(synthetic.make(), true);
            QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(describeInstrumental(e)));
            const Eigen::Vector3d z =
                (e.parameters->vector() - synthetic.truth.vector()).cwiseQuotient(*e.standardErrors());
            QVERIFY2(z.cwiseAbs().maxCoeff() < 6, qPrintable(describeInstrumental(e)));
            squared += z.cwiseAbs2();
            for (Eigen::Index i = 0; i < 3; ++i)
                covered += std::abs(z(i)) < 1.959964 ? 1 : 0;
        }
        // Chi-square with one degree of freedom a run, 5 % in the root allowed for nonlinearity (science.md).
        const boost::math::chi_squared sum(runs);
        const double lowest = boost::math::quantile(sum, falseAlarm) / (1.05 * 1.05);
        const double highest = 1.05 * 1.05 * boost::math::quantile(boost::math::complement(sum, falseAlarm));
        for (Eigen::Index i = 0; i < 3; ++i)
            QVERIFY2(squared(i) > lowest && squared(i) < highest,
                     qPrintable(
                         u"parameter %1: root-mean-square z %2"_s.arg(i).arg(std::sqrt(squared(i) / runs))));
        // The three intervals of a run are correlated, so count as one run's worth at the least.
        const double missed = runs - covered / 3.0;
        const boost::math::binomial misses(runs, 0.05);
        QVERIFY2(missed <= boost::math::quantile(boost::math::complement(misses, falseAlarm)),
                 qPrintable(u"%1 of %2 missed"_s.arg(missed).arg(runs)));
    }

    void anyObjectIsFoundFromTheDataAlone()
    {
        // Natural frequencies from a tenth of a swing a record to near half the sample rate, any damping, any
        // hold: no end may be higher than that of output error.
        GaussianNoise random(42);
        int lost = 0;
        for (std::uint64_t run = 0; run < 150; ++run) {
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
            const Estimate e = instrumentalEstimate(recording, true);
            const Estimate other = outputError(recording, true);
            QVERIFY2(e.status != EstimateStatus::NotConverged, qPrintable(describeInstrumental(e)));
            if (other.status == EstimateStatus::Converged)
                lost += e.status != EstimateStatus::Converged ||
                                e.residuals.sse > other.residuals.sse * (1 + 1e-6)
                            ? 1
                            : 0;
        }
        QVERIFY2(lost <= 1, qPrintable(QString::number(lost)));
    }

    void unitsChangeNothingButUnits_data()
    {
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("position");
        QTest::addColumn<double>("time");
        for (const double force : {1e-6, 1e70}) {
            for (const double position : {1e6, 1e-70})
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
        synthetic.fitPercent = 90;
        Recording recording = synthetic.make();
        const Estimate e = instrumentalEstimate(recording, true);
        for (double& f : recording.force)
            f *= force;
        for (double& y : recording.position)
            y *= position;
        recording.sampleTime_s *= time;
        const Estimate scaled = instrumentalEstimate(recording, true);
        QVERIFY2(scaled.status == EstimateStatus::Converged, qPrintable(describeInstrumental(scaled)));
        const double unit = force / position;
        const MassDampingStiffness back{scaled.parameters->m / unit / time / time,
                                        scaled.parameters->b / unit / time, scaled.parameters->k / unit};
        QVERIFY2(relativeDifference(back, *e.parameters) < 1e-8, qPrintable(describeInstrumental(scaled)));
    }

    void whatCannotBeAnsweredSaysWhy()
    {
        InstrumentalVariablesOptions options;
        options.sampleTime_s = 0.01;
        std::vector<double> noise;
        GaussianNoise random(3);
        for (int i = 0; i < 60; ++i)
            noise.push_back(random());
        const std::vector<double> constant(60, 2.0);
        const auto status = [&](const std::vector<double>& force, const std::vector<double>& position) {
            const Estimate e = estimateInstrumentalVariables(force, position, options);
            return e.parameters || e.message.isEmpty() ? u"an answer without words"_s : toString(e.status);
        };
        QCOMPARE(status({}, {}), u"too_few_samples"_s);
        QCOMPARE(status({1, 2, 3}, {1, 2, 3}), u"too_few_samples"_s);
        QCOMPARE(status(noise, {1, 2, 3}), u"not_applicable"_s);
        QCOMPARE(status(noise, constant), u"not_identifiable"_s);
        QCOMPARE(status(constant, noise), u"not_identifiable"_s);
    }

    void anyNumbersGiveFiniteAnswersOrNone()
    {
        GaussianNoise random(11);
        for (int run = 0; run < 100; ++run) {
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
            InstrumentalVariablesOptions options;
            options.sampleTime_s = std::pow(10.0, -6 + 12 * random.uniform());
            options.hold = run % 2 == 0 ? ForceHold::Zero : ForceHold::First;
            options.lag_s = run % 5 == 0 ? 1.4 * options.sampleTime_s : 0;
            options.freeOffset = run % 4 != 0;
            const Estimate e = estimateInstrumentalVariables(force, position, options);
            QVERIFY(!e.message.isEmpty());
            if (!e.parameters)
                continue;
            QVERIFY2(e.parameters->vector().allFinite() && e.parameters->vector().minCoeff() > 0,
                     qPrintable(describeInstrumental(e)));
            QVERIFY(!e.covariance || e.covariance->allFinite());
            QVERIFY(std::isfinite(e.residuals.sse));
        }
    }
};

GRIPSCOPE_TEST(InstrumentalVariablesTest)
#include "instrumental_variables_test.moc"
