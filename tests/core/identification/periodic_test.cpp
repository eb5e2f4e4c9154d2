// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/identification/periodic/periodic.h"
#include "core/identification/result/identification_json.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QTest>

#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::relativeDifference;
using test::Synthetic;

namespace {

/// Eight periods of 2 times 31 bits of 4 samples.
Synthetic periodicSqueeze()
{
    Synthetic synthetic;
    synthetic.kind = ExcitationKind::InverseRepeat;
    synthetic.bit_s = 0.2;
    synthetic.samples = 1984;
    return synthetic;
}

PeriodicOptions periodicOptions(const Recording& recording)
{
    PeriodicOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = *recording.hold;
    options.lag_s = recording.forceLag_s;
    return options;
}

Estimate periodicEstimate(const Recording& recording)
{
    return estimatePeriodic(recording.force, recording.position, periodicOptions(recording));
}

bool isFinite(const Estimate& e)
{
    return (!e.parameters || e.parameters->vector().allFinite()) &&
           (!e.covariance || e.covariance->allFinite());
}

} // namespace

class PeriodicTest : public QObject {
    Q_OBJECT
private slots:
    void theDriftThatWasTakenOutIsTold()
    {
        // A straight line that rises by 0.5 over the 1984 samples: what the periods differ by, exactly.
        Recording recording = periodicSqueeze().make();
        double size = 0;
        for (std::size_t t = 0; t < recording.size(); ++t) {
            recording.position[t] += 0.5 * static_cast<double>(t) / static_cast<double>(recording.size());
            size = std::max(size, std::abs(recording.position[t]));
        }
        const PeriodicResult result =
            analysePeriodic(recording.force, recording.position, periodicOptions(recording));
        QVERIFY(result.diagnostics);
        const double share = static_cast<double>(result.diagnostics->window.count) / 1984;
        // The start's transient is nearly over when the second period begins.
        QVERIFY(std::abs(result.diagnostics->positionDrift - 0.5 * share) < 1e-3 * size);
        QVERIFY(std::abs(result.diagnostics->forceDrift) < 1e-9);
        QVERIFY(toJson(*result.diagnostics)[u"drift"_s][u"position"].isDouble());
    }
    void identifyKeepsWhatRepetitionTells()
    {
        IdentificationOptions options;
        options.estimators = {Estimator::Periodic};
        options.assess = false;
        const Identification found = identify(periodicSqueeze().make(), options);
        QVERIFY(found.repetition);
        QCOMPARE(found.repetition->periodSamples, std::size_t{248});
        QVERIFY(!identify(Synthetic().make(), options).repetition);
    }
    void aRecordWithoutNoiseGivesTheTruth_data()
    {
        QTest::addColumn<bool>("straight");
        QTest::addColumn<double>("damping");
        QTest::addColumn<double>("lag");
        QTest::addColumn<bool>("moving");
        QTest::newRow("held, overdamped") << false << 1.08 << 0.0 << false;
        QTest::newRow("held, critical, moving at first") << false << 1.0 << 0.0 << true;
        QTest::newRow("straight, overdamped, lag of 1.6 samples") << true << 2.0 << 0.08 << true;
        QTest::newRow("straight, ringing, moving at first") << true << 0.1 << 0.0 << true;
        QTest::newRow("held, ringing, lag, moving at first") << false << 0.1 << 0.02 << true;
        QTest::newRow("held, creeping") << false << 4.0 << 0.0 << false;
        QTest::newRow("negative lag") << true << 0.5 << -0.08 << true;
    }
    void aRecordWithoutNoiseGivesTheTruth()
    {
        QFETCH(bool, straight);
        QFETCH(double, damping);
        QFETCH(double, lag);
        QFETCH(bool, moving);
        Synthetic synthetic = periodicSqueeze();
        const double w = 1.6;
        synthetic.truth = {0.04, 2 * damping * w * 0.04, w * w * 0.04};
        synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
        synthetic.lag_s = lag;
        synthetic.offset = moving ? 50 : 0;
        synthetic.x0 = moving ? 20 : 0;
        synthetic.v0 = moving ? -10 : 0;
        const Estimate e = periodicEstimate(synthetic.make());
        QVERIFY2(e.status == EstimateStatus::Converged, qPrintable(e.message.describe()));
        // What the a priori range of the start's motion and the smooth functions leave of it: far below any
        // noise. Rounding alone would be 1e-10.
        QVERIFY2(relativeDifference(*e.parameters, synthetic.truth) < 1e-5,
                 qPrintable(QString::number(relativeDifference(*e.parameters, synthetic.truth))));
        QVERIFY(*e.fit.simulationPercent > 99.9999);
    }

    void unitsDoNotMatter_data()
    {
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("position");
        QTest::addColumn<double>("time");
        QTest::newRow("micro") << 1e-6 << 1e-6 << 1e-6;
        QTest::newRow("mega") << 1e6 << 1e6 << 1e6;
        QTest::newRow("newtons, metres, 2 kHz") << 10.0 << 1e-5 << 1e-2;
        QTest::newRow("far out") << 1e50 << 1e-50 << 1.0;
    }
    void unitsDoNotMatter()
    {
        QFETCH(double, force);
        QFETCH(double, position);
        QFETCH(double, time);
        Synthetic synthetic = periodicSqueeze();
        synthetic.fitPercent = 90;
        Recording recording = synthetic.make();
        const Estimate plain = periodicEstimate(recording);
        for (double& f : recording.force)
            f *= force;
        for (double& y : recording.position)
            y *= position;
        recording.sampleTime_s *= time;
        const Estimate scaled = periodicEstimate(recording);
        QVERIFY(scaled.status == EstimateStatus::Converged);
        const double unit = force / position;
        const MassDampingStiffness back{scaled.parameters->m / unit / time / time,
                                        scaled.parameters->b / unit / time, scaled.parameters->k / unit};
        // Where the search stops: a step that would change the cost by 1e-10 of a line's noise.
        QVERIFY(relativeDifference(back, *plain.parameters) < 1e-6);
        const Eigen::Vector3d relative = scaled.standardErrors()->cwiseQuotient(scaled.parameters->vector());
        const Eigen::Vector3d before = plain.standardErrors()->cwiseQuotient(plain.parameters->vector());
        QVERIFY((relative - before).cwiseAbs().maxCoeff() < 1e-5 * before.maxCoeff());
    }

    void aStartWrongByTenTimesConverges()
    {
        Synthetic synthetic = periodicSqueeze();
        synthetic.fitPercent = 85;
        const Recording recording = synthetic.make();
        const Estimate own = periodicEstimate(recording);
        for (const double factor : {0.1, 10.0}) {
            PeriodicOptions options = periodicOptions(recording);
            options.start = {synthetic.truth.m * factor, synthetic.truth.b / factor,
                             synthetic.truth.k * factor};
            const Estimate e = estimatePeriodic(recording.force, recording.position, options);
            QVERIFY(e.status == EstimateStatus::Converged);
            QVERIFY(relativeDifference(*e.parameters, *own.parameters) < 1e-6);
        }
    }

    void aKnownPeriodGivesTheSameAnswerAsAFoundOne()
    {
        Synthetic synthetic = periodicSqueeze();
        synthetic.fitPercent = 85;
        const Recording recording = synthetic.make();
        PeriodicOptions options = periodicOptions(recording);
        options.period = 248;
        const PeriodicResult given = analysePeriodic(recording.force, recording.position, options);
        options.period.reset();
        const PeriodicResult found = analysePeriodic(recording.force, recording.position, options);
        QCOMPARE(found.diagnostics->periodSamples, std::size_t(248));
        QCOMPARE(found.diagnostics->periods, std::size_t(8));
        QVERIFY(*found.estimate.parameters == *given.estimate.parameters);
    }

    void lostSamplesLeaveTheLongestRunOfPeriods()
    {
        Synthetic synthetic = periodicSqueeze();
        synthetic.fitPercent = 95;
        Recording recording = synthetic.make();
        PeriodicOptions options = periodicOptions(recording);
        options.period = 248;
        options.lost = {300, 301, 700};
        for (const std::size_t index : options.lost)
            recording.force[index] = recording.position[index] = 1e6;
        const PeriodicResult result = analysePeriodic(recording.force, recording.position, options);
        QVERIFY(result.estimate.status == EstimateStatus::Converged);
        QCOMPARE(result.diagnostics->periods, std::size_t(5));
        QVERIFY(result.diagnostics->window.first > 700);
        const Eigen::Vector3d z = (result.estimate.parameters->vector() - synthetic.truth.vector())
                                      .cwiseQuotient(*result.estimate.standardErrors());
        QVERIFY(z.cwiseAbs().maxCoeff() < 4);
    }

    void evenHarmonicsShowASpringThatIsNotLinear_data()
    {
        QTest::addColumn<double>("quadratic");
        QTest::newRow("linear") << 0.0;
        QTest::newRow("stiffer when pressed") << 0.05;
    }
    void evenHarmonicsShowASpringThatIsNotLinear()
    {
        // F = k x + quadratic x^2 at frequencies far below the resonance, 2 % noise.
        QFETCH(double, quadratic);
        Synthetic synthetic = periodicSqueeze();
        synthetic.fitPercent = 98;
        Recording recording = synthetic.make();
        for (double& y : recording.position)
            y += quadratic * y * y / 5;
        const PeriodicResult result =
            analysePeriodic(recording.force, recording.position, periodicOptions(recording));
        QVERIFY(result.diagnostics->distortionP);
        QCOMPARE(*result.diagnostics->distortionP<1e-4, quadratic> 0);
        QCOMPARE(result.estimate.message.describe().contains(u"nonlinear"_s), quadratic > 0);
        if (quadratic > 0)
            QVERIFY(*result.diagnostics->distortionPercent > 1 &&
                    *result.diagnostics->distortionPercent < 20);
        else
            QVERIFY(*result.diagnostics->distortionPercent < 1);
    }

    void diagnosticsTellTheNoiseOfBothChannels()
    {
        Synthetic synthetic = periodicSqueeze();
        synthetic.samples = 4 * 1984;
        Recording recording = synthetic.make();
        GaussianNoise random(5);
        for (std::size_t i = 0; i < recording.size(); ++i) {
            const double common = random();
            recording.force[i] += 0.1 * common;
            recording.position[i] += 0.3 * (0.6 * common + 0.8 * random());
        }
        const PeriodicResult result =
            analysePeriodic(recording.force, recording.position, periodicOptions(recording));
        QVERIFY(result.diagnostics);
        // Over 2,000 degrees of freedom: 2 %, and two channels; 5 standard deviations.
        QVERIFY(std::abs(result.diagnostics->forceNoise / 0.1 - 1) < 0.1);
        QVERIFY(std::abs(result.diagnostics->positionNoise / 0.3 - 1) < 0.1);
        QVERIFY(std::abs(result.diagnostics->noiseCorrelation - 0.6) < 0.06);
        QVERIFY(result.diagnostics->costP > 1e-3);
        // The first line: 1/G = k - m w^2 + j w b, which a held force delays by half a sample (w T / 2 =
        // 0.013).
        const PeriodicLine& line = result.diagnostics->lines.front();
        const double w = 2 * 3.14159265358979 * line.frequency_Hz;
        QVERIFY(std::abs(w - 2 * 3.14159265358979 / 25.2) < 1e-9); // 8 periods of 2 times 63 bits fit
        const MassDampingStiffness& truth = synthetic.truth;
        const std::complex<double> wanted = 1.0 / std::complex(truth.k - truth.m * w * w, w * truth.b);
        QVERIFY(std::abs(line.response - wanted) < 0.015 * std::abs(wanted) + 5 * line.deviation);
        QVERIFY(line.deviation > 0 && line.deviation < 0.1 * std::abs(wanted));
        const QJsonObject json = toJson(*result.diagnostics);
        QCOMPARE(json[u"period_samples"].toInteger(), 504);
        QCOMPARE(json[u"noise"][u"force"].toDouble(), result.diagnostics->forceNoise);
        QCOMPARE(json[u"lines"].toArray().size(), qsizetype(result.diagnostics->lines.size()));
        QCOMPARE(json[u"lines"].toArray().first()[u"real"].toDouble(), line.response.real());
    }

    void whatCannotBeEstimatedIsSaid()
    {
        Synthetic synthetic = periodicSqueeze();
        Recording recording = synthetic.make();
        PeriodicOptions options = periodicOptions(recording);
        options.period = 600;
        QVERIFY(estimatePeriodic(recording.force, recording.position, options).status ==
                EstimateStatus::TooFewSamples);
        options.period = 111;
        QVERIFY(estimatePeriodic(recording.force, recording.position, options).status ==
                EstimateStatus::NotApplicable);
        options = periodicOptions(recording);
        const std::vector<double> still(recording.size(), 3.0);
        QVERIFY(estimatePeriodic(recording.force, still, options).status == EstimateStatus::NotIdentifiable);
        QVERIFY(estimatePeriodic(still, recording.position, options).status == EstimateStatus::NotApplicable);
        options.lag_s = 1e9;
        QVERIFY(estimatePeriodic(recording.force, recording.position, options).status ==
                EstimateStatus::TooFewSamples);
        synthetic.kind = ExcitationKind::Prbs;
        recording = synthetic.make();
        const Estimate once = periodicEstimate(recording);
        QVERIFY(once.status == EstimateStatus::NotApplicable);
        QVERIFY(once.message.describe().contains(u"inverse-repeat"_s));
    }
    void oneFrequencyIsTooFew()
    {
        Recording recording;
        recording.sampleTime_s = 0.05;
        recording.hold = ForceHold::First;
        for (int t = 0; t < 800; ++t)
            recording.force.push_back(std::sin(2 * 3.14159265358979 * t / 100));
        recording.position =
            simulate(Synthetic().truth, recording.force, {0.05, ForceHold::First, 0, 0, 0, 0});
        QVERIFY(periodicEstimate(recording).status == EstimateStatus::NotIdentifiable);
    }
    void noInputMakesANumberThatIsNone_data()
    {
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("position");
        QTest::addColumn<int>("samples");
        QTest::newRow("nothing") << 1.0 << 1.0 << 0;
        QTest::newRow("three samples") << 1.0 << 1.0 << 3;
        QTest::newRow("twenty samples") << 1.0 << 1.0 << 20;
        QTest::newRow("huge force") << 1e300 << 1.0 << 1984;
        QTest::newRow("huge position") << 1.0 << 1e300 << 1984;
        QTest::newRow("huge over tiny") << 1e300 << 1e-300 << 1984;
        QTest::newRow("tiny over huge") << 1e-300 << 1e300 << 1984;
        QTest::newRow("no force") << 0.0 << 1.0 << 1984;
        QTest::newRow("no position") << 1.0 << 0.0 << 1984;
        QTest::newRow("upside down") << 1.0 << -1.0 << 1984;
    }
    void noInputMakesANumberThatIsNone()
    {
        QFETCH(double, force);
        QFETCH(double, position);
        QFETCH(int, samples);
        Recording recording = periodicSqueeze().make();
        recording.force.resize(static_cast<std::size_t>(samples));
        recording.position.resize(static_cast<std::size_t>(samples));
        for (double& f : recording.force)
            f *= force;
        for (double& y : recording.position)
            y *= position / 20;
        PeriodicOptions options = periodicOptions(recording);
        for (const std::optional<std::size_t> period : {std::optional<std::size_t>(), {248}, {0}, {1}, {5}}) {
            options.period = period;
            const Estimate e = estimatePeriodic(recording.force, recording.position, options);
            QVERIFY(isFinite(e));
            QVERIFY(!e.message.isEmpty());
            if (e.status == EstimateStatus::Converged)
                QVERIFY(e.parameters->vector().minCoeff() > 0 && e.covariance);
        }
    }

    void identifyTakesThePeriodFromTheRecording()
    {
        Recording recording = periodicSqueeze().make();
        recording.provenance.insert(u"excitation_period_samples"_s, u"248"_s);
        QCOMPARE(*excitationPeriod(recording), std::size_t(248));
        const Identification found = identify(recording, {{Estimator::Periodic}, {}, {}, true});
        QVERIFY(found.estimates.front().status == EstimateStatus::Converged);
        QVERIFY(relativeDifference(*found.estimates.front().parameters, Synthetic().truth) < 1e-6);
        recording.provenance.insert(u"excitation_period_samples"_s, u"many"_s);
        QVERIFY(!excitationPeriod(recording));
    }
};

GRIPSCOPE_TEST(PeriodicTest)
#include "periodic_test.moc"
