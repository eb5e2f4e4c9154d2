// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::relativeDifference;
using test::Synthetic;

namespace {

bool finite(const Estimate& e)
{
    const auto good = [](const std::optional<double>& value) { return !value || std::isfinite(*value); };
    bool all = good(e.nuisance.x0) && good(e.nuisance.v0) && good(e.nuisance.offset) &&
               good(e.fit.simulationPercent) && good(e.fit.predictionPercent) && good(e.residuals.sse) &&
               good(e.residuals.whitenessP) && good(e.residuals.inputIndependenceP) &&
               good(e.residuals.errorInflation);
    if (e.parameters)
        all = all && e.parameters->vector().allFinite() && e.parameters->vector().minCoeff() > 0;
    if (e.covariance)
        all = all && e.covariance->allFinite();
    if (e.coefficients)
        all = all && std::isfinite(e.coefficients->a1) && std::isfinite(e.coefficients->a2) &&
              std::isfinite(e.coefficients->b1) && good(e.coefficients->b2) && good(e.coefficients->constant);
    for (const double value : e.simulated)
        all = all && std::isfinite(value);
    return all;
}

IdentificationOptions everyEstimator()
{
    IdentificationOptions options;
    options.estimators = {Estimator::Arx, Estimator::ArxMeanForce, Estimator::Arx221, Estimator::OutputError};
    return options;
}

} // namespace

class IdentificationTest : public QObject {
    Q_OBJECT
private slots:
    void aLagThatNobodyStatedCountsInTheBudget()
    {
        // 20 and 50 us at 2,000 samples a second, and nobody knows: without a line m's interval of can A is a
        // tenth of its error. What m, b, k and their own covariance are does not change.
        for (const double lag : {20e-6, 50e-6}) {
            Synthetic synthetic;
            synthetic.truth = {0.0396, 43.0, 9990.0};
            synthetic.sampleTime_s = 5e-4;
            synthetic.bit_s = 5e-3;
            synthetic.peak = 10;
            synthetic.samples = 2000;
            synthetic.hold = ForceHold::First;
            synthetic.fitPercent = 99;
            synthetic.lag_s = lag;
            Recording recording = synthetic.make();
            recording.forceLag_s = 0;
            const Identification stated = identify(recording);
            QVERIFY(stated.budget.find(u"lag"_s) == nullptr);
            recording.provenance.remove(forceLagSourceKey());
            const Identification unknown = identify(recording);
            QVERIFY(unknown.budget.find(u"lag"_s) != nullptr);
            const CoverageInterval& m = unknown.budget.intervals[0];
            QVERIFY(m.lower < synthetic.truth.m && synthetic.truth.m < m.upper);
            QVERIFY(unknown.object()->parameters == stated.object()->parameters);
            QVERIFY(unknown.object()->covariance == stated.object()->covariance);
            // Once it is measured, the line is that of the measurement.
            recording.forceLag_s = lag;
            recording.chain.forceLagUncertainty_s = 1e-6;
            const Identification measured = identify(recording);
            const auto uncertaintyOf = [](const Identification& one) {
                return one.budget.find(u"lag"_s)->standardUncertainties()(0);
            };
            // 1 us instead of 50 us / sqrt(3), at m that differs by some percent.
            QVERIFY(std::abs(uncertaintyOf(unknown) / uncertaintyOf(measured) - 28.9) < 3);
        }
    }
    void itTellsHowFarItIsAndIsStopped()
    {
        Synthetic synthetic;
        const Recording recording = synthetic.make();
        IdentificationOptions options;
        options.watch = std::make_shared<WorkWatch>();
        QCOMPARE(identify(recording, options).estimates.size(), std::size_t(2));
        QVERIFY(options.watch->share() > 0.5 && options.watch->share() <= 1);
        options.watch = std::make_shared<WorkWatch>();
        options.watch->stop();
        QVERIFY(identify(recording, options).estimates.empty());
        QCOMPARE(options.watch->share(), 0.0);
    }
    void outputErrorIsRecommendedAndRight()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 95;
        const Identification found = identify(synthetic.make());
        QCOMPARE(found.estimates.size(), std::size_t(2));
        QVERIFY(found.estimates[0].estimator == Estimator::Arx);
        QCOMPARE(toString(found.recommended), u"oe"_s);
        QVERIFY(found.best() == found.find(Estimator::OutputError));
        const Eigen::Vector3d z = (found.best()->parameters->vector() - synthetic.truth.vector())
                                      .cwiseQuotient(*found.best()->standardErrors());
        QVERIFY(z.cwiseAbs().maxCoeff() < 4);
    }
    void withoutOutputErrorTheBestSimulationIsRecommended()
    {
        Synthetic synthetic;
        IdentificationOptions options;
        options.estimators = {Estimator::Arx, Estimator::Arx221, Estimator::ArxMeanForce};
        QCOMPARE(toString(identify(synthetic.make(), options).recommended), u"arx221"_s);
    }
    void theHoldIsTheOptionsThenTheRecordingsThenStraight()
    {
        Recording recording = Synthetic().make();
        IdentificationOptions options;
        QVERIFY(identify(recording, options).hold == ForceHold::Zero);
        options.hold = ForceHold::First;
        QVERIFY(identify(recording, options).hold == ForceHold::First);
        recording.hold.reset();
        QVERIFY(identify(recording, IdentificationOptions()).hold == ForceHold::First);
    }
    void theLagOfTheRecordingIsUsed()
    {
        Synthetic synthetic;
        synthetic.lag_s = 0.6 * synthetic.sampleTime_s;
        Recording recording = synthetic.make();
        QVERIFY(relativeDifference(*identify(recording).best()->parameters, synthetic.truth) < 1e-8);
        recording.forceLag_s = 0;
        QVERIFY(relativeDifference(*identify(recording).best()->parameters, synthetic.truth) > 0.01);
    }
    void aGapKeepsItsTimeAndIsFilledByNoEstimator()
    {
        Synthetic synthetic;
        synthetic.samples = 1000;
        Recording recording = synthetic.make();
        const auto cut = [](std::vector<double>& values) {
            values.erase(values.begin() + 300, values.begin() + 310);
        };
        cut(recording.time_s);
        cut(recording.force);
        cut(recording.position);
        const Identification found = identify(recording, everyEstimator());
        QVERIFY((found.choice.window == Window{0, 990}));
        QCOMPARE(found.choice.lostSamples, std::int64_t(10));
        QCOMPARE(found.position.size(), std::size_t(1000));
        QCOMPARE(found.lost.size(), std::size_t(10));
        QCOMPARE(found.lost.front(), std::size_t(300));
        // Output error uses both sides, the others the longer one.
        const Estimate* const outputError = found.find(Estimator::OutputError);
        QVERIFY((outputError->part == Window{0, 1000}));
        QVERIFY(relativeDifference(*outputError->parameters, synthetic.truth) < 1e-8);
        const Estimate* const arx221 = found.find(Estimator::Arx221);
        QVERIFY((arx221->part == Window{310, 690}));
        QCOMPARE(arx221->simulated.size(), std::size_t(690));
        QVERIFY(relativeDifference(*arx221->parameters, synthetic.truth) < 1e-8);
    }
    void onlyTheMovingPartIsIdentified()
    {
        Synthetic synthetic;
        Recording recording = synthetic.make();
        recording.status.assign(recording.size(), StatusArmed);
        for (std::size_t i = 0; i < 300; ++i)
            recording.status[i] |= StatusMoving;
        for (std::size_t i = 300; i < recording.size(); ++i)
            recording.position[i] = 1000; // the gripper let go
        const Identification found = identify(recording);
        QCOMPARE(found.position.size(), std::size_t(300));
        QVERIFY(relativeDifference(*found.best()->parameters, synthetic.truth) < 1e-8);
    }
    void noEstimatorsIsAnAnswerToo()
    {
        IdentificationOptions options;
        options.estimators.clear();
        const Identification found = identify(Synthetic().make(), options);
        QVERIFY(found.best() == nullptr);
        QCOMPARE(toString(found.validity.verdict), u"invalid"_s);
    }
    void badNumbersNeverComeOut_data()
    {
        QTest::addColumn<double>("value");
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("minus infinite") << -std::numeric_limits<double>::infinity();
        QTest::newRow("largest") << std::numeric_limits<double>::max();
        QTest::newRow("minus largest") << std::numeric_limits<double>::lowest();
        QTest::newRow("large") << 1e200;
        QTest::newRow("smallest") << std::numeric_limits<double>::denorm_min();
        QTest::newRow("zero") << 0.0;
    }
    void badNumbersNeverComeOut()
    {
        QFETCH(double, value);
        for (const int where : {0, 1, 2, 3, 4, 5, 6}) {
            Recording recording = Synthetic().make();
            if (where == 0)
                recording.position[57] = value;
            if (where == 1)
                recording.force[57] = value;
            if (where == 2)
                recording.sampleTime_s = value;
            if (where == 3)
                recording.forceLag_s = value;
            if (where == 4)
                std::fill(recording.position.begin(), recording.position.end(), value);
            if (where == 5)
                std::fill(recording.force.begin(), recording.force.end(), value);
            if (where == 6)
                recording.time_s[57] = value;
            for (const bool fixed : {false, true}) {
                IdentificationOptions options = everyEstimator();
                options.freeOffset = !fixed;
                options.initialState = fixed ? InitialState::Rest : InitialState::Free;
                for (const Estimate& e : identify(recording, options).estimates)
                    QVERIFY2(finite(e), qPrintable(u"%1 at %2"_s.arg(toString(e.estimator)).arg(where)));
            }
        }
    }
    void channelsOfDifferentLengthAreNotRead()
    {
        Recording recording = Synthetic().make();
        recording.position.resize(100);
        const Identification found = identify(recording);
        QVERIFY(found.best() == nullptr);
        QCOMPARE(toString(found.estimates[0].status), u"not_applicable"_s);
    }
    void anyGarbageGivesFiniteAnswers()
    {
        GaussianNoise random(11);
        for (int run = 0; run < 300; ++run) {
            const auto samples = static_cast<std::size_t>(60 * random.uniform());
            Recording recording;
            recording.sampleTime_s = std::pow(10, 6 * random());
            const double forceScale = std::pow(10, 20 * random());
            const double positionScale = std::pow(10, 20 * random());
            const int shape = static_cast<int>(5 * random.uniform());
            double walk = 0;
            for (std::size_t i = 0; i < samples; ++i) {
                walk += random();
                recording.time_s.push_back(static_cast<double>(i) * recording.sampleTime_s);
                recording.force.push_back(forceScale * (shape == 0   ? 1
                                                        : shape == 1 ? double(i % 2)
                                                                     : random()));
                recording.position.push_back(positionScale * (shape == 2   ? walk
                                                              : shape == 3 ? std::exp(0.5 * double(i))
                                                                           : random()));
            }
            for (const Estimate& e : identify(recording, everyEstimator()).estimates)
                QVERIFY2(finite(e), qPrintable(u"run %1, %2"_s.arg(run).arg(toString(e.estimator))));
        }
    }
    void theSameInputGivesTheSameBits()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        const Recording recording = synthetic.make();
        const Identification one = identify(recording, everyEstimator());
        const Identification two = identify(recording, everyEstimator());
        QCOMPARE(one.estimates.size(), two.estimates.size());
        for (std::size_t i = 0; i < one.estimates.size(); ++i) {
            QVERIFY(one.estimates[i].parameters == two.estimates[i].parameters); // some determine none
            QVERIFY(one.estimates[i].residual == two.estimates[i].residual);
        }
    }
    void namesReadBack()
    {
        for (const Estimator estimator :
             {Estimator::Arx, Estimator::ArxMeanForce, Estimator::Arx221, Estimator::InstrumentalVariables,
              Estimator::OutputError, Estimator::Duffing, Estimator::Periodic})
            QVERIFY(estimatorFromString(toString(estimator)) == estimator);
        QVERIFY(!estimatorFromString(u"armax"_s));
    }
};

GRIPSCOPE_TEST(IdentificationTest)
#include "identification_test.moc"
